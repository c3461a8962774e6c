// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/nearest.h"

#include "rchal/units/traversal.h"

namespace rc::ddk {
namespace {

using namespace rc::hal;

float squared(const Vec3 &v) { return glm::dot(v, v); }

float toBox(const Vec3 &lower, const Vec3 &upper, const Vec3 &p) { return squared(p - glm::clamp(p, lower, upper)); }

float toSegment(const Vec3 &a, const Vec3 &b, const Vec3 &p) {
  const Vec3 along = b - a;
  const float length = squared(along);
  const float share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0f, 1.0f) : 0;
  return squared(p - (a + share * along));
}

float toTriangle(const HotTriangle &t, const Vec3 &p) {
  const Vec3 normal = glm::cross(t.v1 - t.v0, t.v2 - t.v0);
  const auto isInside = [&](const Vec3 &a, const Vec3 &b) { return glm::dot(glm::cross(b - a, p - a), normal) >= 0; };
  if (squared(normal) > 0 && isInside(t.v0, t.v1) && isInside(t.v1, t.v2) && isInside(t.v2, t.v0)) {
    const float height = glm::dot(p - t.v0, normal);
    return height * height / squared(normal);
  }
  return std::min({toSegment(t.v0, t.v1, p), toSegment(t.v1, t.v2, p), toSegment(t.v2, t.v0, p)});
}

// Squared.
float throughBvh(const GeometryView &geometry, const Vec3 &p) {
  float best = kInfinity;
  const auto enter = [&](const Vec3 &lower, const Vec3 &upper) -> std::optional<float> {
    const float distance = toBox(lower, upper, p);
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
      best = std::min(best, toTriangle(geometry.triangles[block.primitive[i]], p));
    }
  }
  return best;
}

}  // namespace

float nearestSurface(const GeometryView &geometry, const Vec3 &point) {
  if (geometry.triangles.empty()) return kInfinity;
  const AccelView &accel = geometry.accel;
  if (accel.kind == AccelKind::Bvh) return std::sqrt(throughBvh(geometry, point));
  return accel.kind == AccelKind::KdTree ? std::sqrt(toBox(accel.bounds.lower, accel.bounds.upper, point)) : 0;
}

}  // namespace rc::ddk
