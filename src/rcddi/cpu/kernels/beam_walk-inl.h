// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// beam_walk-inl.h: packets through the BVH behind one beam. A node costs one test of its children's boxes for all
// rays; a triangle of a leaf is tested with those packets whose own beams it may meet.
// Reshetov, Soupikov, Hurley: "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005, gives the idea of asking for many
// rays at a time; the leaves work like tiles of a rasteriser.
#if defined(RAYCORE_KERNELS_BEAM_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_BEAM_WALK_INL
#undef RAYCORE_KERNELS_BEAM_WALK_INL
#else
#define RAYCORE_KERNELS_BEAM_WALK_INL
#endif

#include "rcddi/cpu/kernels/beam-inl.h"
#include "rcddi/cpu/kernels/outline-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// A set of triangles on its way through the kernels.
struct Geometry {
  const hal::GeometryView &view;
  uint32_t base;  // number of its first primitive
};

struct StackEntry {
  uint32_t child;  // as in BvhNode8
  float near;
};

// Puts the children that the beam meets onto the stack, the nearest one last.
HWY_INLINE size_t pushChildren(const hal::BvhNode8 &node, const Batch &batch, const Beam &beam, StackEntry *stack,
                               size_t depth) {
  const D8 d;
  using V = hn::Vec<D8>;
  V lanes[kBounds];
  broadcast(d, beam, lanes);
  const V sign = hn::Set(d, beam.zSign), offset = hn::Set(d, beam.zOffset);
  const auto &x = node.planes[batch.kx], &y = node.planes[batch.ky], &z = node.planes[batch.kz];
  const int front = beam.zSign < 0;
  const size_t first = depth;
  for (size_t i = 0; i < hal::BvhNode8::kWidth; i += hn::Lanes(d)) {
    BoxLanes<V> box{hn::Load(d, x[0] + i),
                    hn::Load(d, x[1] + i),
                    hn::Load(d, y[0] + i),
                    hn::Load(d, y[1] + i),
                    hn::MulAdd(hn::Load(d, z[front] + i), sign, offset),
                    hn::MulAdd(hn::Load(d, z[!front] + i), sign, offset)};
    uint32_t bits = bitsOf(d, meets(d, box, lanes));
    if (!bits) continue;
    alignas(32) float near[hal::BvhNode8::kWidth];
    hn::Store(box.near, d, near);
    while (bits) {
      const uint32_t lane = nextBit(bits);
      size_t place = depth++;
      for (; place > first && stack[place - 1].near < near[lane]; --place) stack[place] = stack[place - 1];
      stack[place] = {node.child[i + lane], near[lane]};
    }
  }
  return depth;
}

// Returns the packets that have changed.
template <bool kAny, bool kCommon>
HWY_INLINE uint32_t intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch,
                                   const Beam &beam) {
  BlockOutlines seen;
  uint32_t met = outline(block, batch, beam, seen);
  uint32_t changed = 0;
  while (met) {
    const size_t lane = nextBit(met);
    const uint32_t primitive = block.primitive[lane];
    if (primitive == hal::TriangleBlock4::kNone) break;
    const hal::HotTriangle &triangle = geometry.view.triangles[primitive];
    if (kAny && geometry.view.filtersShadow && triangle.flags & hal::kFiltersShadow) continue;
    uint32_t packets = beam.last - beam.first > 1 ? packetsThatMeet(seen, lane, beam) : 1u << beam.first;
    while (packets) {
      const uint32_t packet = nextBit(packets);
      const bool hit =
          intersectPacket<kAny, kCommon>(batch, seen.corners, lane, triangle, geometry.base + primitive, packet);
      changed |= uint32_t(hit) << packet;
    }
  }
  return changed;
}

// So many packets must have found something for looking how short the beam has become.
constexpr size_t kManyChanges = 4;

template <bool kAny, bool kCommon>
HWY_NOINLINE void walkWithBeam(const Geometry &geometry, Batch &batch, Beam &beam) {
  const hal::AccelView &accel = geometry.view.accel;
  StackEntry stack[hal::kMaxBvhStack];
  stack[0] = {0, -kInfinity};
  uint32_t changed = 0;
  for (size_t depth = 1; depth > 0;) {
    const StackEntry at = stack[--depth];
    if (at.near > beam.all[kFar]) continue;
    if (hwy::PopCount(changed) >= kManyChanges) {
      shorten(batch, changed, beam);
      changed = 0;
    }
    if (at.child & hal::BvhNode8::kLeaf) {
      changed |= intersectBlock<kAny, kCommon>(geometry, accel.blocks[at.child & ~hal::BvhNode8::kLeaf], batch, beam);
      continue;
    }
    if (changed) shorten(batch, changed, beam);
    changed = 0;
    depth = pushChildren(accel.bvhNodes[at.child], batch, beam, stack, depth);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
