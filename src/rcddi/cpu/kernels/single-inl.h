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

#include "rcddi/cpu/kernels/lanes_stack-inl.h"
#include "rcddi/cpu/kernels/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// What of the rays of a packet boxes are tested with. Distance to a plane at b: b * inverse - start, in one fused
// operation; the rounding of `start` is covered by shifting near planes closer and far planes away, and that of the
// rest by kSlack, as in the scalar unit.
struct alignas(64) SlabRays {
  float nearInverse[3][kPacketRays], nearStart[3][kPacketRays];
  float farInverse[3][kPacketRays], farStart[3][kPacketRays];
};
constexpr float kFarther = 1 + 2 * hal::kSlack;

HWY_INLINE void setUp(const Batch &batch, size_t packet, SlabRays &out) {
  const D16 d;
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
    const size_t from = packet * kPacketRays + i;
    for (int axis = 0; axis < 3; ++axis) {
      const auto direction = hn::LoadU(d, batch.direction[axis] + from);
      const auto inverse = inverseOf(d, direction);
      const auto start = hn::Mul(hn::LoadU(d, batch.origin[axis] + from), inverse);
      const auto error = hn::Mul(hn::Abs(start), hn::Set(d, 0x1p-21f)), farther = hn::Set(d, kFarther);
      hn::Store(inverse, d, out.nearInverse[axis] + i);
      hn::Store(hn::Mul(inverse, farther), d, out.farInverse[axis] + i);
      hn::Store(hn::Add(start, error), d, out.nearStart[axis] + i);
      hn::Store(hn::Mul(hn::Sub(start, error), farther), d, out.farStart[axis] + i);
    }
  }
}

// One of them, in all lanes.
struct SlabRay {
  using V = hn::Vec<D8>;
  V nearInverse[3], nearStart[3], farInverse[3], farStart[3];
  size_t near[3], far[3];  // where in BvhNode8::planes the planes lie that the ray meets first and last

  HWY_INLINE SlabRay(const SlabRays &rays, size_t i) {
    const D8 d;
    for (size_t axis = 0; axis < 3; ++axis) {
      nearInverse[axis] = hn::Set(d, rays.nearInverse[axis][i]);
      nearStart[axis] = hn::Set(d, rays.nearStart[axis][i]);
      farInverse[axis] = hn::Set(d, rays.farInverse[axis][i]);
      farStart[axis] = hn::Set(d, rays.farStart[axis][i]);
      near[axis] = (2 * axis + std::signbit(rays.nearInverse[axis][i])) * hal::BvhNode8::kWidth;
      far[axis] = (2 * axis + !std::signbit(rays.nearInverse[axis][i])) * hal::BvhNode8::kWidth;
    }
  }
};

// The children whose boxes the ray meets before tMax, and where.
HWY_INLINE uint32_t meets(const hal::BvhNode8 &node, const SlabRay &ray, float tMax, float *distance) {
  const D8 d;
  const float *planes = node.planes[0][0];
  uint32_t bits = 0;
  for (size_t i = 0; i < hal::BvhNode8::kWidth; i += hn::Lanes(d)) {
    auto near = hn::Zero(d), far = hn::Set(d, tMax * kFarther);
    for (int axis = 0; axis < 3; ++axis) {
      near = hn::Max(near,
                     hn::MulSub(hn::Load(d, planes + ray.near[axis] + i), ray.nearInverse[axis], ray.nearStart[axis]));
      far = hn::Min(far, hn::MulSub(hn::Load(d, planes + ray.far[axis] + i), ray.farInverse[axis], ray.farStart[axis]));
    }
    bits |= bitsOf(d, hn::Le(near, far)) << i;
    hn::Store(near, d, distance + i);
  }
  return bits;
}

struct StackEntry {
  uint32_t child;  // as in BvhNode8
  float near;
};

// Returns the nearest of the children whose bits are set, and puts the others onto the stack, nearer ones later.
HWY_INLINE uint32_t descend(const hal::AccelView &accel, const hal::BvhNode8 &node, uint32_t bits,
                            const float *distance, StackEntry *stack, size_t &depth) {
  uint32_t lane = nextBit(bits);
  if (HWY_LIKELY(!bits)) return node.child[lane];
  StackEntry nearest{node.child[lane], distance[lane]};
  const size_t first = depth;
  do {
    lane = nextBit(bits);
    StackEntry other{node.child[lane], distance[lane]};
    const bool swap = other.near < nearest.near;
    const StackEntry farther = swap ? nearest : other;
    nearest = swap ? other : nearest;
    prefetch(accel, farther.child);
    size_t place = depth++;
    for (; place > first && stack[place - 1].near < farther.near; --place) stack[place] = stack[place - 1];
    stack[place] = farther;
  } while (bits);
  return nearest.child;
}

// What the test of a block finds; see packet-inl.h. Returns the lanes with a hit that may count.
struct BlockHits {
  alignas(16) float t[4], u[4], v[4];
  uint32_t onEdge;  // lanes that the scalar unit decides
};
HWY_INLINE uint32_t testBlock(const hal::TriangleBlock4 &block, const Batch &batch, size_t ray, BlockHits &out) {
  const D4 d;
  using V = hn::Vec<D4>;
  const V zero = hn::Zero(d);
  uint32_t found = 0;
  out.onEdge = 0;
  for (size_t i = 0; i < hal::TriangleBlock4::kWidth; i += hn::Lanes(d)) {
    Corner<V> corners[3];
    for (int v = 0; v < 3; ++v) {
      const float(&vertex)[3][4] = block.vertices[v];
      const V x = hn::Sub(hn::Load(d, vertex[batch.kx] + i), hn::Set(d, batch.origin[batch.kx][ray]));
      const V y = hn::Sub(hn::Load(d, vertex[batch.ky] + i), hn::Set(d, batch.origin[batch.ky][ray]));
      const V z = hn::Sub(hn::Load(d, vertex[batch.kz] + i), hn::Set(d, batch.origin[batch.kz][ray]));
      corners[v] = {hn::Sub(x, hn::Mul(hn::Set(d, batch.sx[ray]), z)),
                    hn::Sub(y, hn::Mul(hn::Set(d, batch.sy[ray]), z)), z};
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
    const V t = hn::Mul(hn::Mul(height, hn::Set(d, batch.sz[ray])), scale);
    const auto near = hn::And(hn::Gt(t, zero), hn::Le(t, hn::Set(d, batch.t[ray])));
    found |= bitsOf(d, hn::Or(onEdge, hn::And(inside, near))) << i;
    out.onEdge |= bitsOf(d, onEdge) << i;
    hn::Store(t, d, out.t + i);
    hn::Store(hn::Mul(wb, scale), d, out.u + i);
    hn::Store(hn::Mul(wc, scale), d, out.v + i);
  }
  return found;
}

// The triangles of a block. Returns whether the ray is blocked.
template <bool kAny>
HWY_INLINE bool intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch, size_t ray) {
  BlockHits hits;
  uint32_t found = testBlock(block, batch, ray, hits);
  while (HWY_UNLIKELY(found)) {
    const uint32_t lane = nextBit(found);
    const uint32_t primitive = block.primitive[lane];
    if (primitive == hal::TriangleBlock4::kNone) continue;
    const hal::HotTriangle &triangle = geometry.view.triangles[primitive];
    hal::Hit hit{hits.t[lane], hits.u[lane], hits.v[lane], 0};
    const bool onEdge = hits.onEdge >> lane & 1;
    if (onEdge && !hal::intersectTriangle(hal::ShearedRay(batch.ray(ray)), triangle, hit)) continue;
    hit.primitive = geometry.base + primitive;
    if constexpr (kAny) {
      if (hit.t > 0 && hit.t < batch.t[ray] && blockRay(geometry, batch, ray, primitive, hit)) return true;
    } else if (improves(batch, ray, hit)) {
      record(batch, ray, hit);
    }
  }
  return false;
}

template <bool kAny>
HWY_NOINLINE void walkAlone(const Geometry &geometry, Batch &batch, const SlabRays &slabs, size_t i, uint32_t child) {
  const hal::AccelView &accel = geometry.view.accel;
  const SlabRay slab(slabs, i % kPacketRays);
  StackEntry stack[hal::kMaxBvhStack];
  size_t depth = 0;
  for (;;) {
    alignas(32) float distance[hal::BvhNode8::kWidth];
    uint32_t bits = 1;
    while (!(child & hal::BvhNode8::kLeaf)) {
      const hal::BvhNode8 &node = accel.bvhNodes[child];
      bits = meets(node, slab, batch.t[i], distance);
      if (!bits) break;
      child = descend(accel, node, bits, distance, stack, depth);
    }
    if (bits) {
      const hal::TriangleBlock4 &block = accel.blocks[child & ~hal::BvhNode8::kLeaf];
      if (intersectBlock<kAny>(geometry, block, batch, i)) return;
    }
    do {
      if (depth == 0) return;
      child = stack[--depth].child;
    } while (stack[depth].near > batch.t[i] * kFarther);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
