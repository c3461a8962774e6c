// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/nearest.h"

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

struct Entry {
  uint32_t child;  // as in BvhNode8
  float distance;  // squared
};

// The children that are nearer than `best`, the nearest one last.
int push(const BvhNode8 &node, const Vec3 &p, float best, Entry *stack, int depth) {
  const int first = depth;
  for (uint32_t i = 0; i < BvhNode8::kWidth && node.child[i] != 0; ++i) {
    const Vec3 lower{node.planes[0][0][i], node.planes[1][0][i], node.planes[2][0][i]};
    const Vec3 upper{node.planes[0][1][i], node.planes[1][1][i], node.planes[2][1][i]};
    const float distance = toBox(lower, upper, p);
    if (!(distance < best)) continue;
    int place = depth++;
    for (; place > first && stack[place - 1].distance < distance; --place) stack[place] = stack[place - 1];
    stack[place] = {node.child[i], distance};
  }
  return depth;
}

float throughBvh(const GeometryView &geometry, const Vec3 &p) {
  float best = kInfinity;
  Entry stack[kMaxBvhStack];
  stack[0] = {0, 0};
  for (int depth = 1; depth > 0;) {
    const Entry at = stack[--depth];
    if (!(at.distance < best)) continue;
    if (!(at.child & BvhNode8::kLeaf)) {
      depth = push(geometry.accel.bvhNodes[at.child], p, best, stack, depth);
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
