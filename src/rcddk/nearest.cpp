// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/nearest.h"

#include "rchal/units/traversal.h"

namespace rc::ddk {
namespace {

using namespace rc::hal;

// In double: squares of distances to triangles that are 1e10 large, or as far away, are beyond float.
using Vec3d = glm::dvec3;

double squared(const Vec3d &v) { return glm::dot(v, v); }

double toBox(const Vec3 &lower, const Vec3 &upper, const Vec3 &p) {
  return squared(Vec3d(p) - Vec3d(glm::clamp(p, lower, upper)));
}

double toSegment(const Vec3d &a, const Vec3d &b, const Vec3d &p) {
  const Vec3d along = b - a;
  const double length = squared(along);
  const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
  return squared(p - (a + share * along));
}

double toTriangle(const HotTriangle &t, const Vec3d &p) {
  const Vec3d a(t.v0), b(t.v1), c(t.v2), normal = glm::cross(b - a, c - a);
  const auto isInside = [&](const Vec3d &from, const Vec3d &to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  if (squared(normal) > 0 && isInside(a, b) && isInside(b, c) && isInside(c, a)) {
    const double height = glm::dot(p - a, normal);
    return height * height / squared(normal);
  }
  return std::min({toSegment(a, b, p), toSegment(b, c, p), toSegment(c, a, p)});
}

float throughBvh(const GeometryView &geometry, const Vec3 &p) {
  float best = kInfinity;
  const auto enter = [&](const Vec3 &lower, const Vec3 &upper) -> std::optional<float> {
    const auto distance = static_cast<float>(std::sqrt(toBox(lower, upper, p)));
    return distance < best ? std::optional(distance) : std::nullopt;
  };
  BvhEntry stack[kMaxBvhStack];
  stack[0] = {0, 0};
  for (int depth = 1; depth > 0;) {
    const BvhEntry at = stack[--depth];
    if (!(at.enter < best)) continue;
    if (!(at.child & BvhNode8::kLeaf)) {
      depth = pushChildren(geometry.accel.bvhNodes[at.child], enter, stack, depth);
      continue;
    }
    const TriangleBlock4 &block = geometry.accel.blocks[at.child & ~BvhNode8::kLeaf];
    for (uint32_t i = 0; i < block.count(); ++i) {
      best = std::min(best, static_cast<float>(std::sqrt(toTriangle(geometry.triangles[block.primitive[i]], p))));
    }
  }
  return best;
}

}  // namespace

float nearestSurface(const GeometryView &geometry, const Vec3 &point) {
  if (geometry.triangles.empty()) return kInfinity;
  const AccelView &accel = geometry.accel;
  if (accel.kind == AccelKind::Bvh) return throughBvh(geometry, point);
  if (accel.kind != AccelKind::KdTree) return 0;
  return static_cast<float>(std::sqrt(toBox(accel.bounds.lower, accel.bounds.upper, point)));
}

}  // namespace rc::ddk
