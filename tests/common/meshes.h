// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// meshes.h: triangles for tests, the same on each run.
#pragma once

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "rcddk/geometry.h"
#include "rchal/device.h"

namespace rc::test {

using Triangles = std::vector<hal::HotTriangle>;

inline hal::HotTriangle triangle(const Vec3 &a, const Vec3 &b, const Vec3 &c, uint32_t material = 0,
                                 uint32_t flags = 0) {
  return {a, b, c, material, flags, 0};
}

// Three vertices each.
inline Triangles trianglesOf(std::span<const Vec3> vertices) {
  Triangles triangles;
  for (size_t i = 0; i + 2 < vertices.size(); i += 3) {
    triangles.push_back(triangle(vertices[i], vertices[i + 1], vertices[i + 2]));
  }
  return triangles;
}

// A surface over a grid of n x n cells, 2 n n triangles; point(u, v) for 0 <= u, v <= 1.
template <class Point>
Triangles gridSurface(int n, Point &&point) {
  Triangles triangles;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto at = [&](int di, int dj) { return point(float(i + di) / float(n), float(j + dj) / float(n)); };
      triangles.push_back(triangle(at(0, 0), at(1, 0), at(1, 1)));
      triangles.push_back(triangle(at(0, 0), at(1, 1), at(0, 1)));
    }
  }
  return triangles;
}

// Hills of several scales over the unit square, around y = 0.
inline Triangles terrain(int n) {
  return gridSurface(n, [](float u, float v) {
    return Vec3(u, 0.1f * std::sin(9 * u + 2) * std::cos(11 * v) + 0.03f * std::sin(57 * u * v + 40 * v), v);
  });
}

// A torus knot's tube: concave, with thin parts close to one another.
inline Triangles knot(int n) {
  return gridSurface(n, [](float u, float v) {
    const float t = 6.2831853f * u, s = 6.2831853f * v, r = 0.1f;
    const auto curve = [](float a) {
      return Vec3(std::cos(2 * a) * (1 + 0.4f * std::cos(3 * a)), std::sin(2 * a) * (1 + 0.4f * std::cos(3 * a)),
                  0.4f * std::sin(3 * a));
    };
    const Vec3 along = glm::normalize(curve(t + 0.01f) - curve(t));
    const Vec3 side = glm::normalize(glm::cross(along, Vec3(0.3f, 0.1f, 1))), up = glm::cross(side, along);
    return curve(t) + r * (std::cos(s) * side + std::sin(s) * up);
  });
}

// Everything a structure can stumble over: needles, equal triangles, flat layers, tiny next to huge ones.
inline Triangles soup(int n, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto point = [&] {
    const float x = unit(random), y = unit(random), z = unit(random);
    return Vec3(x, y, z);
  };
  Triangles triangles;
  while (int(triangles.size()) < n) {
    const Vec3 a = point(), b = point(), c = point();
    switch (triangles.size() % 5) {
      case 0:
        triangles.push_back(triangle(a, b, c));
        break;
      case 1:
        triangles.push_back(triangle(a, a + 0.9f * b, a + 0.9f * b + 1e-3f * c));
        break;
      case 2:
        triangles.push_back(triangles.back());
        break;
      case 3: {
        const float layer = std::floor(4 * a.y) / 4;
        triangles.push_back(triangle({a.x, layer, a.z}, {b.x, layer, b.z}, {c.x, layer, c.z}));
        break;
      }
      default:
        triangles.push_back(triangle(a, a + 1e-3f * b, a + 1e-3f * c));
    }
  }
  return triangles;
}

// Rays from around the unit cube and from inside it, some along the axes.
inline std::vector<hal::Ray> randomRays(size_t count, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<hal::Ray> rays;
  while (rays.size() < count) {
    const float x = unit(random), y = unit(random), z = unit(random);
    const float dx = unit(random), dy = unit(random), dz = unit(random);
    const Vec3 origin = (rays.size() % 2 ? 1.0f : 3.0f) * Vec3(x, y, z);
    Vec3 direction = normalizedOr(rays.size() % 2 ? Vec3(dx, dy, dz) : Vec3(dx, dy, dz) - origin, {0, 0, 1});
    if (rays.size() % 50 == 0) direction = {0, 0, dz < 0 ? -1.0f : 1.0f};
    rays.push_back({origin, direction});
  }
  return rays;
}

// A scene of one static set, with the tables a SceneView needs.
struct TestScene {
  Triangles triangles;
  std::vector<hal::TriangleAttributes> attributes;
  std::vector<hal::MaterialRow> materials{hal::kNamedMaterials};
  std::vector<hal::TextureView> textures;
  std::vector<hal::LightRow> lights;
  ddk::Accel accel;
  hal::SceneView view;

  explicit TestScene(Triangles all, AccelKind kind = AccelKind::Bvh) : triangles(std::move(all)) {
    attributes.resize(triangles.size());
    const Workers workers(2);
    accel = ddk::buildAccel(kind, triangles, workers);
  }
  TestScene(const TestScene &) = delete;
  TestScene &operator=(const TestScene &) = delete;

  const hal::SceneView &update() {
    bool filters = false;
    for (hal::HotTriangle &triangle : triangles) hal::setPlane(triangle);
    for (const hal::HotTriangle &t : triangles) filters |= (t.flags & hal::kFiltersShadow) != 0;
    view.geometry[0] = {triangles, attributes, {}, accel.view(), filters};
    view.materials = materials;
    view.textures = textures;
    view.lights = lights;
    return view;
  }
};

}  // namespace rc::test
