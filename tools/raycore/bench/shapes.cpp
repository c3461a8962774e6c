// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "bench/shapes.h"

#include <cmath>

namespace rc::tool {
namespace {

Vec3 unitOr(const Vec3 &v, const Vec3 &other) { return glm::length(v) > 1e-12f ? glm::normalize(v) : other; }

}  // namespace

Primitive surfaceOf(int columns, int rows, const std::function<Vec3(float u, float v)> &point) {
  Primitive primitive;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const float u = float(column) / float(columns), v = float(row) / float(rows), step = 1e-3f;
      const Vec3 along = point(u + step, v) - point(u - step, v), up = point(u, v + step) - point(u, v - step);
      primitive.positions.push_back(point(u, v));
      primitive.normals.push_back(unitOr(glm::cross(along, up), Vec3(0, 1, 0)));
      primitive.uvs[0].emplace_back(u, v);
    }
  }
  const auto at = [&](int column, int row) { return uint32_t(row * (columns + 1) + column); };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const uint32_t a = at(column, row), b = at(column + 1, row), c = at(column + 1, row + 1), d = at(column, row + 1);
      primitive.indices.insert(primitive.indices.end(), {a, b, c, a, c, d});
    }
  }
  return primitive;
}

Primitive sphere(const Vec3 &centre, float radius, int columns, int rows) {
  Primitive primitive = surfaceOf(columns, rows, [&](float u, float v) {
    const float around = 2 * kPi * u, up = kPi * (v - 0.5f);
    return centre + radius * Vec3(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
  });
  for (size_t i = 0; i < primitive.positions.size(); ++i)
    primitive.normals[i] = glm::normalize(primitive.positions[i] - centre);
  return primitive;
}

Primitive panel(const Vec3 &corner, const Vec3 &across, const Vec3 &up) {
  Primitive primitive;
  primitive.positions = {corner, corner + across, corner + across + up, corner + up};
  primitive.normals.assign(4, glm::normalize(glm::cross(across, up)));
  primitive.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  primitive.indices = {0, 1, 2, 0, 2, 3};
  return primitive;
}

Primitive block(const Vec3 &low, const Vec3 &high, float turn) {
  const Vec3 size = high - low, middle = 0.5f * (low + high);
  Primitive all;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 u(0), v(0), w(0);
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    w[axis] = size[axis];
    append(all, panel(low + w, u, v));
    append(all, panel(low, v, u));
  }
  const float c = std::cos(turn), s = std::sin(turn);
  const auto turned = [&](const Vec3 &p) { return Vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x); };
  for (Vec3 &p : all.positions) p = middle + turned(p - middle);
  for (Vec3 &n : all.normals) n = turned(n);
  return all;
}

void append(Primitive &to, const Primitive &from) {
  const auto first = static_cast<uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
  to.uvs[0].insert(to.uvs[0].end(), from.uvs[0].begin(), from.uvs[0].end());
  for (const uint32_t index : from.indices) to.indices.push_back(first + index);
}

int addBody(Scene &scene, Primitive primitive, int material) {
  primitive.material = material;
  Mesh mesh;
  mesh.primitives.push_back(std::move(primitive));
  scene.meshes.push_back(std::move(mesh));
  Node node;
  node.mesh = static_cast<int>(scene.meshes.size()) - 1;
  scene.nodes.push_back(std::move(node));
  scene.order.push_back(static_cast<int>(scene.nodes.size()) - 1);
  return scene.order.back();
}

int addMaterial(Scene &scene, const std::string &name, const Vec3 &linear, float metallic, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = Vec4(linear, 1);
  material.metallic = metallic;
  material.roughness = roughness;
  material.doubleSided = true;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

}  // namespace rc::tool
