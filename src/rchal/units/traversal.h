// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// traversal.h: one ray through a KD-tree or a BVH; the T&I unit of the guide. [G 1.2, 1.2a]
// In: SceneView, Ray.  Out: Hit, or what gets through to a light.  Next: units/hit_point.h
//
// Hits are ordered by (t, primitive number), so every structure gives the same hit, ties included. Distances
// to planes and to triangles are rounded differently; kSlack keeps the trees from dropping a box too early.
#pragma once

#include <optional>

#include "rchal/units/coverage.h"
#include "rchal/units/intersection.h"

namespace rc::hal {

inline constexpr float kSlack = 1e-5f;
inline constexpr float kPassedSlack = 1e-4f;  // for where a search goes on: distances to needles are rounded by more

// The part of a ray that the trees need.
struct TraversalRay {
  Vec3 origin, inverse;  // inverse: 1 / direction, finite also where a component is 0
  float begin;           // boxes that end before it are passed

  explicit TraversalRay(const Ray &ray, const HitOrder &after = {})
      : origin(ray.origin), begin(std::max(0.0f, after.t * (1 - kPassedSlack))) {
    for (int axis = 0; axis < 3; ++axis) {
      const float d = ray.direction[axis];
      inverse[axis] = 1.0f / (std::abs(d) < 1e-20f ? std::copysign(1e-20f, d) : d);
    }
  }
};

// The interval of the ray inside the box, within [begin, tMax]; nothing if it misses.
struct Interval {
  float enter, leave;
};
inline std::optional<Interval> clip(const TraversalRay &ray, const Vec3 &lower, const Vec3 &upper, float tMax) {
  const Vec3 t0 = (lower - ray.origin) * ray.inverse;
  const Vec3 t1 = (upper - ray.origin) * ray.inverse;
  const float enter = std::max(ray.begin, maxComponent(glm::min(t0, t1))) * (1 - kSlack);
  const float leave = std::min(tMax, minComponent(glm::max(t0, t1))) * (1 + kSlack);
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

// A leaf that has inner(node) is told of the inner nodes too, as rcddk/ray_probe.cpp counts them.
// Each walk calls leaf(indices) for leaves from near to far until it returns true, or until all boxes
// that begin before tMax are done. tMax is a reference: it may shrink while the walk goes on.

// A child of a BVH node on its way through a walk.
struct BvhEntry {
  uint32_t child;  // as in BvhNode8
  float enter;
};

// Puts the children that are met onto the stack, the nearest one last. enter(lower, upper): where a box is met, if at
// all.
template <class Enter>
int pushChildren(const BvhNode8 &node, Enter &&enter, BvhEntry *stack, int depth) {
  const int first = depth;
  for (uint32_t i = 0; i < BvhNode8::kWidth && node.child[i] != 0; ++i) {
    const Bounds box = node.box(i);
    const std::optional<float> met = enter(box.lower, box.upper);
    if (!met) continue;
    int place = depth++;
    for (; place > first && stack[place - 1].enter < *met; --place) stack[place] = stack[place - 1];
    stack[place] = {node.child[i], *met};
  }
  return depth;
}

template <class Leaf>
void walkBvh(const AccelView &accel, const TraversalRay &ray, const float &tMax, Leaf &&leaf) {
  if (accel.bvhNodes.empty()) return;
  BvhEntry stack[kMaxBvhStack];
  stack[0] = {0, 0};
  for (int depth = 1; depth > 0;) {
    const BvhEntry at = stack[--depth];
    if (at.enter > tMax) continue;
    if (at.child & BvhNode8::kLeaf) {
      const TriangleBlock4 &block = accel.blocks[at.child & ~BvhNode8::kLeaf];
      if (leaf(std::span<const uint32_t>(block.primitive, block.count()))) return;
    } else {
      if constexpr (requires { leaf.inner(accel.bvhNodes[0]); }) leaf.inner(accel.bvhNodes[at.child]);
      const auto enter = [&](const Vec3 &lower, const Vec3 &upper) -> std::optional<float> {
        const auto inside = clip(ray, lower, upper, tMax);
        return inside ? std::optional(inside->enter) : std::nullopt;
      };
      depth = pushChildren(accel.bvhNodes[at.child], enter, stack, depth);
    }
  }
}

// A ray that starts on the plane crosses it at t = 0, from the side it does not go to.
inline bool meetsLeftFirst(const KdNode8 &node, float origin, float inverse) {
  return origin < node.split || (origin == node.split && inverse >= 0);
}

template <class Leaf>
void walkKdTree(const AccelView &accel, const TraversalRay &ray, const float &tMax, Leaf &&leaf) {
  struct Entry {
    uint32_t node;
    float enter, leave;
  };
  Entry stack[kMaxTreeDepth];
  int depth = 0;
  if (accel.kdNodes.empty()) return;
  const auto root = clip(ray, accel.bounds.lower, accel.bounds.upper, tMax);
  if (!root) return;
  Entry at{0, root->enter, root->leave};
  for (;;) {
    const KdNode8 &node = accel.kdNodes[at.node];
    if (!node.isLeaf()) {
      if constexpr (requires { leaf.inner(node); }) leaf.inner(node);
      const uint32_t axis = node.axis();
      const float origin = ray.origin[axis];
      const float t = (node.split - origin) * ray.inverse[axis];
      const bool leftFirst = meetsLeftFirst(node, origin, ray.inverse[axis]);
      const uint32_t near = leftFirst ? at.node + 1 : node.right();
      const uint32_t far = leftFirst ? node.right() : at.node + 1;
      const float tEarly = t * (1 - kSlack), tLate = t * (1 + kSlack);
      if (t < 0 || tEarly > at.leave) {
        at.node = near;
      } else if (tLate < at.enter) {
        at.node = far;
      } else {
        stack[depth++] = {far, std::max(at.enter, tEarly), at.leave};
        at = {near, at.enter, std::min(at.leave, tLate)};
      }
      continue;
    }
    if (leaf(accel.primitives.subspan(node.offset, node.count()))) return;
    do {
      if (depth == 0) return;
      --depth;
    } while (stack[depth].enter > tMax);
    at = stack[depth];
  }
}

// Without a structure: one leaf that holds everything, a block of indices at a time.
template <class Leaf>
void walkAll(size_t count, Leaf &&leaf) {
  uint32_t block[64];
  for (size_t first = 0; first < count; first += std::size(block)) {
    const size_t n = std::min(std::size(block), count - first);
    for (size_t i = 0; i < n; ++i) block[i] = static_cast<uint32_t>(first + i);
    if (leaf(std::span<const uint32_t>(block, n))) return;
  }
}

template <class Leaf>
void walk(const GeometryView &geometry, const TraversalRay &ray, const float &tMax, Leaf &&leaf) {
  switch (geometry.accel.kind) {
    case AccelKind::KdTree:
      return walkKdTree(geometry.accel, ray, tMax, leaf);
    case AccelKind::Bvh:
      return walkBvh(geometry.accel, ray, tMax, leaf);
    case AccelKind::Exhaustive:
      return walkAll(geometry.triangles.size(), leaf);
  }
}

// What a search for the nearest hit does with the leaves of one set of triangles, whose numbers begin at base.
struct NearestSearch {
  std::span<const HotTriangle> triangles;
  const ShearedRay &ray;
  uint32_t base;
  const HitOrder &after;  // hits up to here do not count
  Hit &best;

  bool operator()(std::span<const uint32_t> indices) const {
    for (const uint32_t index : indices) {
      Hit hit;
      if (!intersectTriangle(ray, triangles[index], hit)) continue;
      hit.primitive = base + index;
      const HitOrder order{hit.t, hit.primitive};
      if (after < order && order < HitOrder{best.t, best.primitive}) best = hit;
    }
    return false;
  }
};

// The first hit after `after` and not beyond tMax.
inline Hit nextHit(const SceneView &scene, const Ray &ray, const HitOrder &after, float tMax) {
  const TraversalRay traversal(ray, after);
  const ShearedRay sheared(ray);
  Hit best;
  best.t = tMax;
  uint32_t base = 0;
  for (const GeometryView &geometry : scene.geometry) {
    walk(geometry, traversal, best.t, NearestSearch{geometry.triangles, sheared, base, after, best});
    base += static_cast<uint32_t>(geometry.triangles.size());
  }
  return best.found() ? best : Hit{};
}

inline Hit closestHit(const SceneView &scene, const Ray &ray) { return nextHit(scene, ray, HitOrder{}, kInfinity); }

// The part of a ray on which something may be in the way of light, both ends left out.
struct Reach {
  float begin = 0, end = kInfinity;  // as t
  bool fromLight = false;            // the ray runs with the light, not towards it

  // Of a ray, as sides of triangles count.
  Vec3 towardsLight(const Vec3 &direction) const { return fromLight ? -direction : direction; }
};

// visit(hit) for each one, in the order of the ray, until it returns false.
template <class Visit>
void forEachHit(const SceneView &scene, const Ray &ray, const Reach &reach, Visit &&visit) {
  for (HitOrder last{reach.begin, kNoPrimitive};;) {
    const Hit hit = nextHit(scene, ray, last, reach.end);
    if (!(hit.t < reach.end) || !visit(hit)) return;
    last = {hit.t, hit.primitive};
  }
}

// Whether a triangle that lets none through is in the way.
inline bool isBlocked(const SceneView &scene, const Ray &ray, const Reach &reach) {
  const TraversalRay traversal(ray);
  const ShearedRay sheared(ray);
  bool blocked = false;
  for (const GeometryView &geometry : scene.geometry) {
    walk(geometry, traversal, reach.end, [&](std::span<const uint32_t> indices) {
      for (const uint32_t index : indices) {
        Hit hit;
        if (!intersectTriangle(sheared, geometry.triangles[index], hit)) continue;
        if (!(hit.t > reach.begin && hit.t < reach.end)) continue;
        if (passageOf(geometry, index, reach.towardsLight(ray.direction)) == Passage::Blocked) return blocked = true;
      }
      return false;
    });
    if (blocked) return true;
  }
  return false;
}

}  // namespace rc::hal
