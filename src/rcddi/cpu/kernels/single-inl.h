// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// single-inl.h: one ray through the BVH: the boxes of all children of a node at once, then the triangles of a leaf.
// For rays that go their own ways.
#if defined(RAYCORE_KERNELS_SINGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_SINGLE_INL
#undef RAYCORE_KERNELS_SINGLE_INL
#else
#define RAYCORE_KERNELS_SINGLE_INL
#endif

#include "rcddi/cpu/kernels/beam_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// What of a ray the boxes are tested with. Distance to a plane at b: b * inverse - start, in one fused operation; the
// rounding of `start` is covered by shifting near planes closer and far planes away.
struct SingleRay {
  const hal::Ray &ray;
  hal::ShearedRay sheared;
  float inverse[3], nearStart[3], farStart[3];
  int front[3];  // which of a box's planes the ray meets first

  explicit SingleRay(const hal::Ray &from) : ray(from), sheared(from) {
    for (int axis = 0; axis < 3; ++axis) {
      const float d = from.direction[axis];
      // So small a component moves the ray by less than boxes are widened.
      const float small = 1e-8f * std::abs(from.direction[sheared.kz]);
      inverse[axis] = 1.0f / (std::abs(d) < small ? std::copysign(small, d) : d);
      const float start = from.origin[axis] * inverse[axis], error = std::abs(start) * 0x1p-21f;
      nearStart[axis] = start + error;
      farStart[axis] = start - error;
      front[axis] = std::signbit(inverse[axis]);
    }
  }
};

HWY_INLINE size_t pushChildren(const hal::BvhNode8 &node, const SingleRay &ray, float tMax, StackEntry *stack,
                               size_t depth) {
  const D8 d;
  const size_t first = depth;
  for (size_t i = 0; i < hal::BvhNode8::kWidth; i += hn::Lanes(d)) {
    auto near = hn::Zero(d), far = hn::Set(d, kInfinity);
    for (int axis = 0; axis < 3; ++axis) {
      const auto inverse = hn::Set(d, ray.inverse[axis]);
      const float(&planes)[2][8] = node.planes[axis];
      near =
          hn::Max(near, hn::MulSub(hn::Load(d, planes[ray.front[axis]] + i), inverse, hn::Set(d, ray.nearStart[axis])));
      far =
          hn::Min(far, hn::MulSub(hn::Load(d, planes[!ray.front[axis]] + i), inverse, hn::Set(d, ray.farStart[axis])));
    }
    const auto end = hn::Mul(hn::Min(far, hn::Set(d, tMax)), hn::Set(d, 1 + 2 * hal::kSlack));
    uint32_t bits = bitsOf(d, hn::Le(near, end));
    if (!bits) continue;
    alignas(32) float distance[hal::BvhNode8::kWidth];
    hn::Store(near, d, distance);
    while (bits) {
      const uint32_t lane = nextBit(bits);
      size_t place = depth++;
      for (; place > first && stack[place - 1].near < distance[lane]; --place) stack[place] = stack[place - 1];
      stack[place] = {node.child[i + lane], distance[lane]};
    }
  }
  return depth;
}

// Calls the scalar unit's order of hits in one lane.
HWY_INLINE void keepBetter(const hal::Hit &hit, hal::Hit &best) {
  if (hit.t > 0 && hal::HitOrder{hit.t, hit.primitive} < hal::HitOrder{best.t, best.primitive}) best = hit;
}

// What the test of a block finds; see packet-inl.h. Returns the lanes with a hit that may count.
struct BlockHits {
  alignas(16) float t[4], u[4], v[4];
  uint32_t onEdge;  // lanes that the scalar unit decides
};
HWY_INLINE uint32_t testBlock(const hal::TriangleBlock4 &block, const hal::ShearedRay &s, float tMax, BlockHits &out) {
  const D4 d;
  using V = hn::Vec<D4>;
  const V zero = hn::Zero(d);
  uint32_t found = 0;
  out.onEdge = 0;
  for (size_t i = 0; i < hal::TriangleBlock4::kWidth; i += hn::Lanes(d)) {
    Corner<V> corners[3];
    for (int v = 0; v < 3; ++v) {
      const V z = hn::Sub(hn::Load(d, block.vertices[v][s.kz] + i), hn::Set(d, s.origin[s.kz]));
      const V x = hn::Sub(hn::Load(d, block.vertices[v][s.kx] + i), hn::Set(d, s.origin[s.kx]));
      const V y = hn::Sub(hn::Load(d, block.vertices[v][s.ky] + i), hn::Set(d, s.origin[s.ky]));
      corners[v] = {hn::Sub(x, hn::Mul(hn::Set(d, s.sx), z)), hn::Sub(y, hn::Mul(hn::Set(d, s.sy), z)), z};
    }
    const auto &[a, b, c] = corners;
    const V wa = hn::Sub(hn::Mul(c.x, b.y), hn::Mul(c.y, b.x));
    const V wb = hn::Sub(hn::Mul(a.x, c.y), hn::Mul(a.y, c.x));
    const V wc = hn::Sub(hn::Mul(b.x, a.y), hn::Mul(b.y, a.x));
    const V least = hn::Min(hn::Min(wa, wb), wc), most = hn::Max(hn::Max(wa, wb), wc);
    const auto inside = hn::Or(hn::Ge(least, zero), hn::Le(most, zero));
    if (hn::AllFalse(d, inside)) continue;
    const auto onEdge = hn::And(inside, hn::Or(hn::Eq(least, zero), hn::Eq(most, zero)));
    const V scale = hn::Div(hn::Set(d, 1.0f), hn::Add(hn::Add(wa, wb), wc));
    const V height = hn::Add(hn::Add(hn::Mul(wa, a.z), hn::Mul(wb, b.z)), hn::Mul(wc, c.z));
    const V t = hn::Mul(hn::Mul(height, hn::Set(d, s.sz)), scale);
    const auto near = hn::And(hn::Gt(t, zero), hn::Le(t, hn::Set(d, tMax)));
    found |= bitsOf(d, hn::Or(onEdge, hn::And(inside, near))) << i;
    out.onEdge |= bitsOf(d, onEdge) << i;
    hn::Store(t, d, out.t + i);
    hn::Store(hn::Mul(wb, scale), d, out.u + i);
    hn::Store(hn::Mul(wc, scale), d, out.v + i);
  }
  return found;
}

// The triangles of a block. kAny: whether one that is opaque lies before best.t.
template <bool kAny>
HWY_INLINE bool intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, const SingleRay &ray,
                               hal::Hit &best) {
  BlockHits hits;
  uint32_t found = testBlock(block, ray.sheared, best.t, hits);
  while (HWY_UNLIKELY(found)) {
    const uint32_t lane = nextBit(found);
    const uint32_t primitive = block.primitive[lane];
    if (primitive == hal::TriangleBlock4::kNone) continue;
    const hal::HotTriangle &triangle = geometry.view.triangles[primitive];
    if (kAny && geometry.view.filtersShadow && triangle.flags & hal::kFiltersShadow) continue;
    hal::Hit hit{hits.t[lane], hits.u[lane], hits.v[lane], 0};
    if ((hits.onEdge >> lane & 1) && !hal::intersectTriangle(ray.sheared, triangle, hit)) continue;
    hit.primitive = geometry.base + primitive;
    if (kAny && hit.t > 0 && hit.t < best.t) return true;
    if (!kAny) keepBetter(hit, best);
  }
  return false;
}

// kAny: returns whether the ray is blocked before best.t; else best becomes the nearest hit, and false is returned.
template <bool kAny>
HWY_NOINLINE bool walkAlone(const Geometry &geometry, const hal::Ray &from, hal::Hit &best) {
  const hal::AccelView &accel = geometry.view.accel;
  const SingleRay ray(from);
  StackEntry stack[hal::kMaxBvhStack];
  stack[0] = {0, 0};
  for (size_t depth = 1; depth > 0;) {
    const StackEntry at = stack[--depth];
    if (at.near > best.t * (1 + 2 * hal::kSlack)) continue;
    if (at.child & hal::BvhNode8::kLeaf) {
      if (intersectBlock<kAny>(geometry, accel.blocks[at.child & ~hal::BvhNode8::kLeaf], ray, best)) return true;
    } else {
      depth = pushChildren(accel.bvhNodes[at.child], ray, best.t, stack, depth);
    }
  }
  return false;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
