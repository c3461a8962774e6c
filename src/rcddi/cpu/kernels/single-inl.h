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

#include "rcddi/cpu/kernels/block-inl.h"
#include "rcddi/cpu/kernels/lanes_stack-inl.h"

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
                            const float (&distance)[hal::BvhNode8::kWidth], StackEntry *stack, size_t &depth) {
  if (HWY_LIKELY(!(bits & (bits - 1)))) return node.child[nextBit(bits)];
  visitBits<2>(bits, [&](uint32_t lane) HWY_ATTR {
    prefetch(accel, node.child[lane]);
    stack[depth + countBeneath(distance, bits, lane)] = {node.child[lane], distance[lane]};
  });
  depth += hwy::PopCount(bits) - 1;
  return stack[depth].child;
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
      if (intersectBlock<kAny>(geometry, block, batch, i) && kAny) return;
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
