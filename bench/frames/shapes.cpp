// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/shapes.h"

#include <numbers>

namespace rc::bench {
namespace {

using std::numbers::pi;

bool hasArea(const SurfacePoint &a, const SurfacePoint &b, const SurfacePoint &c) {
  return glm::cross(b.position - a.position, c.position - a.position) != Vec3(0);
}

void addTriangle(Mesh &mesh, const SurfacePoint &a, const SurfacePoint &b, const SurfacePoint &c) {
  if (!hasArea(a, b, c)) return;
  mesh.vertices.insert(mesh.vertices.end(), {a.position, b.position, c.position});
  mesh.normals.insert(mesh.normals.end(), {a.normal, b.normal, c.normal});
}

void append(Mesh &mesh, const Mesh &more) {
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
}

// The middle of the knot's rope.
glm::dvec3 trefoil(double t) {
  const double radius = 2 + std::cos(3 * t);
  return glm::dvec3(radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t)) / 3.0;
}

}  // namespace

Mesh grid(int rows, int columns, const std::function<SurfacePoint(double, double)> &point) {
  const auto at = [&](int i, int j) { return point(double(i) / rows, double(j) / columns); };
  Mesh mesh;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const SurfacePoint a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1), d = at(i + 1, j);
      addTriangle(mesh, a, b, c);
      addTriangle(mesh, a, c, d);
    }
  }
  return mesh;
}

Mesh ball(const Vec3 &centre, float radius, int rows, int columns) {
  return grid(rows, columns, [&](double u, double v) -> SurfacePoint {
    // Exactly the same points where the ball closes.
    const double across = u == 0 || u == 1 ? 0 : std::sin(pi * u), around = v == 1 ? 0 : 2 * pi * v;
    const Vec3 normal(across * std::cos(around), std::cos(pi * u), across * std::sin(around));
    return {centre + radius * normal, normal};
  });
}

Mesh quad(const Vec3 &corner, const Vec3 &right, const Vec3 &up) {
  const Vec3 normal = glm::normalize(glm::cross(right, up));
  return grid(1, 1, [&](double u, double v) -> SurfacePoint {
    return {corner + float(v) * right + float(u) * up, normal};
  });
}

Mesh box(const Vec3 &lower, const Vec3 &upper) {
  const Vec3 size = upper - lower, x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  Mesh mesh = quad(lower + z, x, y);
  for (const Mesh &side : {quad(lower + x, -x, y), quad(lower + x + z, -z, y), quad(lower, z, y),
                           quad(lower + y + z, x, -z), quad(lower, x, z)}) {
    append(mesh, side);
  }
  return mesh;
}

Mesh knot(const Vec3 &centre, float size, float thickness) {
  return grid(400, 40, [&](double u, double v) -> SurfacePoint {
    const double along = u == 1 ? 0 : 2 * pi * u, around = v == 1 ? 0 : 2 * pi * v;
    const glm::dvec3 here = trefoil(along), forward = trefoil(along + 1e-3) - here;
    const glm::dvec3 side = glm::normalize(glm::cross(forward, {0.3, 0.1, 1}));
    const glm::dvec3 up = glm::normalize(glm::cross(side, forward));
    const Vec3 normal(std::cos(around) * side + std::sin(around) * up);
    return {centre + size * Vec3(here) + thickness * normal, normal};
  });
}

}  // namespace rc::bench
