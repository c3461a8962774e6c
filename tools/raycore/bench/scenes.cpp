// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "bench/scenes.h"

#include <array>
#include <cmath>

#include "bench/shapes.h"

namespace rc::tool {
namespace {

constexpr Vec3 kWhite{0.75f, 0.75f, 0.75f}, kRed{0.6f, 0.04f, 0.04f}, kGreen{0.1f, 0.45f, 0.1f},
    kBlue{0.08f, 0.15f, 0.6f};

// A room with two blocks: few triangles, everything in the picture is a surface.
Scene box() {
  Scene scene;
  const int white = addMaterial(scene, "white", kWhite), red = addMaterial(scene, "red", kRed),
            green = addMaterial(scene, "green", kGreen);
  addBody(scene, panel({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), white);
  addBody(scene, panel({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}), white);
  addBody(scene, panel({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}), white);
  addBody(scene, panel({-1, 0, 1}, {0, 0, -2}, {0, 2, 0}), red);
  addBody(scene, panel({1, 0, -1}, {0, 0, 2}, {0, 2, 0}), green);
  addBody(scene, block({-0.65f, 0, -0.6f}, {-0.05f, 1.2f, 0}, 0.3f), white);
  addBody(scene, block({0.1f, 0, 0}, {0.7f, 0.6f, 0.6f}, -0.3f), white);
  return scene;
}

// Mirrors, glass and matt spheres in rows: rays of every kind.
Scene spheres() {
  Scene scene;
  const int metal = addMaterial(scene, "metal", {0.9f, 0.85f, 0.7f}, 1, 0.05f),
            glass = addMaterial(scene, "glass", {0.95f, 0.97f, 1}, 0, 0), matt = addMaterial(scene, "matt", kRed);
  Material &clear = scene.materials[size_t(glass)];
  clear.transmission = 1;
  clear.thickness = 1;
  clear.doubleSided = false;
  const std::array<int, 3> materials{metal, glass, matt};
  for (size_t row = 0; row < 5; ++row) {
    for (size_t column = 0; column < 5; ++column) {
      const Vec3 centre(float(column) * 1.1f, 0.5f, float(row) * 1.1f);
      addBody(scene, sphere(centre, 0.5f, 64, 32), materials[(5 * row + column) % 3]);
    }
  }
  return scene;
}

// A tube along a torus knot: many triangles, a small body in an empty picture.
Scene knot() {
  constexpr float kThickness = 0.32f;
  Scene scene;
  const auto path = [](float u) {
    const float a = 2 * kPi * u * 2, b = 2 * kPi * u * 3, r = 1.5f + 0.55f * std::cos(b);
    return Vec3(r * std::cos(a), 0.75f * std::sin(b), r * std::sin(a));
  };
  addBody(scene,
          surfaceOf(1024, 64,
                    [&](float u, float v) {
                      const Vec3 along = glm::normalize(path(u + 1e-3f) - path(u - 1e-3f));
                      const Vec3 side = glm::normalize(glm::cross(along, Vec3(0.1f, 1, 0.2f)));
                      const float turn = 2 * kPi * v;
                      return path(u) + kThickness * (std::cos(turn) * side + std::sin(turn) * glm::cross(side, along));
                    }),
          addMaterial(scene, "glaze", kBlue, 0, 0.3f));
  return scene;
}

// Hills as far as one sees: long flat rays through a large tree.
Scene terrain() {
  Scene scene;
  addBody(scene,
          surfaceOf(400, 400,
                    [](float u, float v) {
                      float height = 0, size = 1;
                      for (int octave = 0; octave < 6; ++octave, size *= 2) {
                        height += std::sin(7.1f * size * u + 1.3f * size) * std::cos(6.3f * size * v) / size;
                      }
                      return Vec3(10 * u, 0.45f * height, -10 * v);
                    }),
          addMaterial(scene, "hills", {0.2f, 0.33f, 0.12f}));
  return scene;
}

ShowSettings overTheHills() {
  ShowSettings settings;
  settings.eye = Vec3(5, 1.6f, 0.5f);
  settings.lookAt = Vec3(5, 0, -5);
  return settings;
}

Image disc() {
  constexpr int kSize = 64;
  Image image{"disc", kSize, kSize, {}};
  for (int i = 0; i < kSize * kSize; ++i) {
    const Vec2 at = (Vec2(i % kSize, i / kSize) + 0.5f) / float(kSize) - 0.5f;
    const auto alpha = uint8_t(glm::length(at) < 0.45f ? 255 : 0);
    image.rgba.insert(image.rgba.end(), {90, 150, 60, alpha});
  }
  return image;
}

// Leaves cut out of squares: rays and shadows pass through holes.
Scene leaves() {
  Scene scene;
  scene.images.push_back(disc());
  scene.textures.push_back({0, Wrap::Clamp, Wrap::Clamp});
  Material &leaf = scene.materials[size_t(addMaterial(scene, "leaf", Vec3(1)))];
  leaf.baseTexture.texture = 0;
  leaf.alphaMode = AlphaMode::Mask;
  Random random;
  const auto any = [&] { return Vec3(random.next(), random.next(), random.next()) - 0.5f; };
  Primitive all;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 place = any() * 4.0f, across = glm::normalize(any()), up = glm::normalize(glm::cross(across, any()));
    append(all, panel(place, 0.3f * across, 0.3f * up));
  }
  addBody(scene, std::move(all), 0);
  return scene;
}

// A wheel of 40 balls that turns: its structure is built for each frame.
Scene wheel() {
  Scene scene;
  const int matt = addMaterial(scene, "matt", kBlue);
  Primitive balls;
  for (int i = 0; i < 40; ++i) {
    const float turn = 2 * kPi * float(i) / 40;
    append(balls, sphere({2 * std::cos(turn), 2 * std::sin(turn), 0}, 0.14f, 32, 16));
  }
  const int node = addBody(scene, std::move(balls), matt);
  addBody(scene, panel({-2.5f, -2.5f, -0.5f}, {5, 0, 0}, {0, 5, 0}), addMaterial(scene, "wall", kWhite));
  Channel channel;
  channel.node = node;
  channel.path = Path::Rotation;
  channel.times = {0, 1, 2};
  channel.values = {0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, -1};
  channel.width = 4;
  scene.animations.push_back({"turn", {channel}});
  return scene;
}

ShowSettings turning() {
  ShowSettings settings;
  settings.animation.assign(1, '0');  // GCC 12 warns of the other spelling
  return settings;
}

ShowSettings usual() { return {}; }

ShowSettings onChecker() {
  ShowSettings settings;
  settings.ground = GroundKind::Checker;
  settings.background = "gradient";
  return settings;
}

ShowSettings intoTheBox() {
  ShowSettings settings;
  settings.eye = Vec3(0, 1, 3.4f);
  settings.lookAt = Vec3(0, 1, 0);
  return settings;
}

constexpr BenchScene kScenes[] = {{"box", "a room with two blocks", box, intoTheBox},
                                  {"spheres", "25 spheres of metal, glass, plaster", spheres, onChecker},
                                  {"knot", "a tube along a knot", knot, usual},
                                  {"terrain", "hills to the horizon", terrain, overTheHills},
                                  {"leaves", "3,000 leaves with an alpha mask", leaves, usual},
                                  {"wheel", "40 balls that turn", wheel, turning}};

constexpr const char *kFiles[] = {"cornell/cornell_box.obj",         "obj/stanford-bunny.obj",
                                  "obj/teapot-normals-uv.obj",       "gltf/ToyCar.glb",
                                  "gltf/TransmissionTest.glb",       "gltf/CesiumMilkTruck.glb",
                                  "gltf/stanford-dragon-203k.glb",   "gltf/stanford-dragon-871k.glb",
                                  "noncommercial/DamagedHelmet.glb", "noncommercial/sponza-dabrovic.obj"};

}  // namespace

std::span<const BenchScene> builtInScenes() { return kScenes; }

std::span<const char *const> filesOfTheSet() { return kFiles; }

}  // namespace rc::tool
