// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/scenes.h"

#include <cstdio>
#include <map>
#include <tuple>

#include "frames/glass.h"

namespace rc::bench {
namespace {

using Vertices = std::vector<Vec3>;

Vec3 flatNormal(const Vec3 *triangle) {
  return normalizedOr(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), {0, 1, 0});
}

// The mean of the normals of all triangles at a place.
Vertices smoothNormals(const Vertices &vertices) {
  const auto key = [](const Vec3 &v) { return std::tuple(v.x, v.y, v.z); };
  std::map<std::tuple<float, float, float>, Vec3> sums;
  for (size_t i = 0; i < vertices.size(); ++i) sums[key(vertices[i])] += flatNormal(&vertices[i - i % 3]);
  Vertices normals;
  for (size_t i = 0; i < vertices.size(); ++i) {
    normals.push_back(normalizedOr(sums[key(vertices[i])], flatNormal(&vertices[i - i % 3])));
  }
  return normals;
}

// Triangles first ... end - 1.
Mesh part(const Vertices &vertices, size_t first, size_t end, const Surface &surface) {
  return {{vertices.begin() + std::ptrdiff_t(3 * first), vertices.begin() + std::ptrdiff_t(3 * end)}, {}, surface};
}

void makeBunny(const Soup &soup, FrameScene &scene) {
  const float y = -0.992f;
  const Vec3 a{-4, y, -4}, b{-4, y, 4}, c{4, y, 4}, d{4, y, -4};
  scene.meshes = {{soup.vertices, smoothNormals(soup.vertices), {{0.8f, 0.6f, 0.4f}, 0.4f, 40}},
                  {{a, b, c, a, c, d}, {}, {{0.2f, 0.25f, 0.3f}, 0.3f, 60, 0.6f}}};
}

// The floor may be a mirror, or as smooth as one.
void makeSponza(const Soup &soup, const std::optional<Surface> &floor, FrameScene &scene) {
  Mesh walls{{}, {}, {{0.75f, 0.68f, 0.55f}, 0.1f, 20}}, ground;
  for (size_t i = 0; i < soup.vertices.size(); i += 3) {
    const Vec3 *triangle = &soup.vertices[i];
    const bool low = std::max({triangle[0].y, triangle[1].y, triangle[2].y}) < 0.15f;
    Mesh &mesh = floor && low && std::abs(flatNormal(triangle).y) > 0.9f ? ground : walls;
    mesh.vertices.insert(mesh.vertices.end(), triangle, triangle + 3);
  }
  scene.meshes.push_back(walls);
  if (!floor) return;
  ground.surface = *floor;
  scene.meshes.push_back(ground);
}

// A ball with bumps: 2 n^2 triangles.
Vertices makeBall(int n) {
  const auto point = [&](int i, int j) {
    const float a = 3.14159265f * float(i) / float(n), b = 6.2831853f * float(j % n) / float(n);
    const float radius = 1 + 0.1f * std::sin(6 * a) * std::cos(5 * b);
    return radius * Vec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
  };
  Vertices vertices;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      vertices.insert(vertices.end(), {a, b, c, a, c, d});
    }
  }
  return vertices;
}

constexpr Vec3 kMovingFoot{-5.5f, 0.6f, 0};

// Stands the mesh, 3.2 units high or wide, into the hall.
Mesh makeMoving(Vertices vertices) {
  Vec3 lower(kInfinity), upper(-kInfinity);
  for (const Vec3 &v : vertices) lower = glm::min(lower, v), upper = glm::max(upper, v);
  const float scale = 3.2f / std::max(upper.x - lower.x, upper.y - lower.y);
  const Vec3 foot{(lower.x + upper.x) / 2, lower.y, (lower.z + upper.z) / 2};
  for (Vec3 &v : vertices) v = (v - foot) * scale + kMovingFoot;
  Mesh mesh{std::move(vertices), {}, {{0.7f, 0.3f, 0.3f}, 0.5f, 40}};
  mesh.normals = smoothNormals(mesh.vertices);
  return mesh;
}

constexpr int kBallCells = 71;  // 10,082 triangles

// Balls side by side under the vault of the hall, each of 2 * 7 * 7 triangles.
void makeSwarm(FrameScene &scene) {
  const Mesh ball = makeMoving(makeBall(7));
  for (int i = 0; i < 100; ++i) {
    Mesh copy = ball;
    const auto column = i % 10, row = i / 10;
    for (Vec3 &v : copy.vertices) {
      v = kMovingFoot + 0.12f * (v - kMovingFoot) + Vec3(float(column) - 4.5f, 0.6f * float(row), 0) * 0.6f;
    }
    scene.moving.push_back(std::move(copy));
  }
}

std::optional<FrameScene> hills(const std::string &name, const std::string &folder) {
  const std::optional<Soup> soup = loadSoup(name, folder);
  if (!soup) return std::nullopt;
  return FrameScene{name, name, {{soup->vertices, {}, {}}}, {}, soup->camera, {soup->light}};
}

// The first is the bunny's own light, the others stand about the bunny in a ring.
std::optional<FrameScene> underLights(const std::string &name, const std::string &folder, int count) {
  std::optional<FrameScene> scene = loadFrameScene("bunny", folder);
  if (!scene) return std::nullopt;
  for (int i = 1; i < count; ++i) {
    const float angle = 0.8f * float(i);
    scene->lights.push_back({3 * std::cos(angle), 3, 3 * std::sin(angle)});
  }
  scene->name = name;
  return scene;
}

std::optional<FrameScene> roomOfMirrors(const std::string &name, const std::string &folder, int bounces) {
  std::optional<FrameScene> scene = loadFrameScene("cornell", folder);
  for (Mesh &mesh : scene->meshes) mesh.surface.reflection = 0.85f;
  scene->name = name;
  scene->bounces = bounces;
  return scene;
}

bool writeSoup(const std::string &path, const Vertices &vertices) {
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  const auto triangles = static_cast<uint32_t>(vertices.size() / 3);
  bool whole = std::fwrite(&triangles, 4, 1, file) == 1;
  whole &= std::fwrite(vertices.data(), sizeof(Vec3), vertices.size(), file) == vertices.size();
  return std::fclose(file) == 0 && whole;
}

}  // namespace

std::vector<Mesh> cornellMeshes(const Soup &soup) {
  const Surface white{Vec3(0.75f)}, block{Vec3(0.7f), 0.4f, 40}, mirror{Vec3(0.05f), 0.6f, 80, 0.85f};
  return {part(soup.vertices, 0, 6, white),
          part(soup.vertices, 6, 8, {{0.1f, 0.6f, 0.1f}}),
          part(soup.vertices, 8, 10, {{0.6f, 0.08f, 0.08f}}),
          part(soup.vertices, 10, 12, white),
          part(soup.vertices, 12, 22, block),
          part(soup.vertices, 22, 32, mirror)};
}

std::optional<FrameScene> loadFrameScene(const std::string &name, const std::string &folder) {
  if (std::optional<FrameScene> scene = loadGlassScene(name)) return scene;
  if (const size_t digits = name.find_first_of("0123456789"); digits != 0 && digits != std::string::npos) {
    const int number = std::atoi(name.c_str() + digits);
    const std::string kind = name.substr(0, digits);
    if (kind == "hills") return hills(name, folder);
    if (kind == "lights") return underLights(name, folder, number);
    if (kind == "bounces") return roomOfMirrors(name, folder, number);
  }
  const bool moves = name.starts_with("dyn"), hall = moves || name.starts_with("sponza") || name == "swarm";
  const std::optional<Soup> soup = loadSoup(hall ? "sponza" : name, folder);
  if (!soup) return std::nullopt;
  FrameScene scene{name, name, {}, {}, soup->camera, {soup->light}};
  if (name == "cornell") {
    scene.meshes = cornellMeshes(*soup);
  } else if (name == "bunny") {
    makeBunny(*soup, scene);
  } else if (name == "swarm") {
    makeSponza(*soup, std::nullopt, scene);
    makeSwarm(scene);
  } else if (!moves) {
    const Surface mirror{Vec3(0.4f), 0.3f, 60, 0.5f};
    makeSponza(*soup, name == "sponzamirror" ? std::optional(mirror) : std::nullopt, scene);
  } else {
    makeSponza(*soup, std::nullopt, scene);
    const std::optional<Soup> bunny = loadSoup("bunny", folder);
    if (!bunny) return std::nullopt;
    scene.moving = {makeMoving(name == "dyn70k" ? bunny->vertices : makeBall(kBallCells))};
    scene.peer = name == "dyn70k" ? "dyn:bunny:low" : "dyn:ball10k:low";
  }
  return scene;
}

void deform(const Mesh &still, int frame, std::vector<Vec3> &vertices) {
  const float angle = 0.05f * float(frame), c = std::cos(angle), s = std::sin(angle);
  vertices.resize(still.vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    const float x = still.vertices[i].x - kMovingFoot.x, z = still.vertices[i].z;
    vertices[i] = {c * x + s * z + kMovingFoot.x, still.vertices[i].y * (1 + 0.05f * std::sin(3 * x + angle)),
                   c * z - s * x};
  }
}

void writeSoups(const std::string &folder, const std::string &scenes) {
  for (const auto &[file, name] : {std::pair{"cornell", "cornell"}, {"bunny", "bunny"}, {"sponza66k", "sponza"}}) {
    const std::optional<Soup> soup = loadSoup(name, scenes);
    if (soup) writeSoup(folder + "/" + file + ".tri", soup->vertices);
  }
  writeSoup(folder + "/ball10k.tri", makeBall(kBallCells));
}

}  // namespace rc::bench
