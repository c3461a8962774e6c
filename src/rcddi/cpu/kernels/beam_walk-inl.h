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
#include "rcddi/cpu/kernels/packet-inl.h"

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

// The triangles of a block: boxes, and the corners in the axes of the batch.
struct alignas(16) BlockView {
  float corners[3][3][hal::TriangleBlock4::kWidth];  // by vertex, axis: as intersectPacket() wants them
  float box[6][hal::TriangleBlock4::kWidth];         // as in BoxLanes
  uint32_t met;                                      // triangles that the whole beam may meet
};

HWY_INLINE void view(const hal::TriangleBlock4 &block, const Batch &batch, const Beam &beam, BlockView &out) {
  const D4 d;
  using V = hn::Vec<D4>;
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  const V sign = hn::Set(d, beam.zSign), offset = hn::Set(d, beam.zOffset);
  const bool back = beam.zSign < 0;
  V lanes[kBounds];
  broadcast(d, beam, lanes);
  out.met = 0;
  for (size_t i = 0; i < hal::TriangleBlock4::kWidth; i += hn::Lanes(d)) {
    V least[3], most[3];
    V margin = hn::Set(d, 1e-36f);  // what boxes have all around (rcddk/accel/builder.cpp, boxMargin)
    for (int k = 0; k < 3; ++k) {
      const V a = hn::Load(d, block.vertices[0][axes[k]] + i), b = hn::Load(d, block.vertices[1][axes[k]] + i);
      const V c = hn::Load(d, block.vertices[2][axes[k]] + i);
      const V origin = hn::Set(d, batch.common ? batch.origin[axes[k]][0] : 0.0f);
      hn::Store(hn::Sub(a, origin), d, out.corners[0][k] + i);
      hn::Store(hn::Sub(b, origin), d, out.corners[1][k] + i);
      hn::Store(hn::Sub(c, origin), d, out.corners[2][k] + i);
      least[k] = hn::Min(hn::Min(a, b), c);
      most[k] = hn::Max(hn::Max(a, b), c);
      margin = hn::Max(margin, hn::Mul(hn::Max(hn::Abs(least[k]), hn::Abs(most[k])), hn::Set(d, 0x1p-21f)));
    }
    BoxLanes<V> box{hn::Sub(least[0], margin),
                    hn::Add(most[0], margin),
                    hn::Sub(least[1], margin),
                    hn::Add(most[1], margin),
                    hn::Sub(hn::MulAdd(back ? most[2] : least[2], sign, offset), margin),
                    hn::Add(hn::MulAdd(back ? least[2] : most[2], sign, offset), margin)};
    hn::Store(box.xLower, d, out.box[0] + i);
    hn::Store(box.xUpper, d, out.box[1] + i);
    hn::Store(box.yLower, d, out.box[2] + i);
    hn::Store(box.yUpper, d, out.box[3] + i);
    hn::Store(box.near, d, out.box[4] + i);
    hn::Store(box.far, d, out.box[5] + i);
    out.met |= bitsOf(d, meets(d, box, lanes)) << i;
  }
}

// Packets whose beams may meet a triangle of the block.
HWY_INLINE uint32_t packetsThatMeet(const BlockView &block, size_t triangle, const Beam &beam) {
  const D16 d;
  using V = hn::Vec<D16>;
  uint32_t bits = 0;
  for (size_t p = 0; p < kPackets; p += hn::Lanes(d)) {
    BoxLanes<V> box{hn::Set(d, block.box[0][triangle]), hn::Set(d, block.box[1][triangle]),
                    hn::Set(d, block.box[2][triangle]), hn::Set(d, block.box[3][triangle]),
                    hn::Set(d, block.box[4][triangle]), hn::Set(d, block.box[5][triangle])};
    V lanes[kBounds];
    for (size_t k = 0; k < kBounds; ++k) lanes[k] = hn::Load(d, beam.packets[k] + p);
    bits |= bitsOf(d, meets(d, box, lanes)) << p;
  }
  return bits;
}

// Returns the packets that have changed.
template <bool kAny, bool kCommon>
HWY_INLINE uint32_t intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch,
                                   const Beam &beam) {
  BlockView seen;
  view(block, batch, beam, seen);
  uint32_t changed = 0;
  while (seen.met) {
    const size_t lane = nextBit(seen.met);
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

template <bool kAny, bool kCommon>
HWY_NOINLINE void walkWithBeam(const Geometry &geometry, Batch &batch, Beam &beam) {
  const hal::AccelView &accel = geometry.view.accel;
  StackEntry stack[hal::kMaxBvhStack];
  stack[0] = {0, -kInfinity};
  for (size_t depth = 1; depth > 0;) {
    const StackEntry at = stack[--depth];
    if (at.near > beam.all[kFar]) continue;
    if (at.child & hal::BvhNode8::kLeaf) {
      const uint32_t changed =
          intersectBlock<kAny, kCommon>(geometry, accel.blocks[at.child & ~hal::BvhNode8::kLeaf], batch, beam);
      if (changed) shorten(batch, changed, beam);
    } else {
      depth = pushChildren(accel.bvhNodes[at.child], batch, beam, stack, depth);
    }
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
