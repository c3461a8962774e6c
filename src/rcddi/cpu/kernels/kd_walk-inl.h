// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// kd_walk-inl.h: packets through the KD-tree. Each lane carries the part of its ray that lies in the cell; at a plane
// the parts before and behind it go to the children. Rays need not go the same way: a lane that meets the children in
// the other order than most still has the right parts, and finds the same hit.
// Wald, Slusallek, Benthin, Wagner: "Interactive Rendering with Coherent Ray Tracing", Computer Graphics Forum 20(3),
// 2001; Reshetov: "Omnidirectional Ray Tracing Traversal Algorithm for KD-Trees", RT 2006, lets directions differ.
#if defined(RAYCORE_KERNELS_KD_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_KD_WALK_INL
#undef RAYCORE_KERNELS_KD_WALK_INL
#else
#define RAYCORE_KERNELS_KD_WALK_INL
#endif

#include "rcddi/cpu/kernels/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

struct alignas(64) KdRays {
  float inverse[3][kLanes];
};

// The parts of the rays inside a cell; those of rays that miss it end before they start.
struct alignas(64) KdEntry {
  float enter[kLanes], leave[kLanes];
  uint32_t node;
};

HWY_INLINE void setUp(const Batch &batch, size_t packet, KdRays &rays) {
  const D16 d;
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto direction = hn::LoadU(d, batch.direction[axis] + packet * kPacketRays + i);
      hn::Store(inverseOf(d, direction), d, rays.inverse[axis] + i);
    }
  }
}

// The parts inside the box of all triangles.
HWY_INLINE void enter(const hal::AccelView &accel, const Batch &batch, size_t packet, const KdRays &rays,
                      KdEntry &root) {
  const D16 d;
  root.node = 0;
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
    auto near = hn::Zero(d), far = hn::Set(d, kInfinity);
    for (int axis = 0; axis < 3; ++axis) {
      const auto origin = hn::LoadU(d, batch.origin[axis] + packet * kPacketRays + i);
      const auto inverse = hn::Load(d, rays.inverse[axis] + i);
      const auto a = hn::Mul(hn::Sub(hn::Set(d, accel.bounds.lower[axis]), origin), inverse);
      const auto b = hn::Mul(hn::Sub(hn::Set(d, accel.bounds.upper[axis]), origin), inverse);
      near = hn::Max(near, hn::Min(a, b));
      far = hn::Min(far, hn::Max(a, b));
    }
    far = hn::Min(far, hn::Load(d, batch.t + packet * kPacketRays + i));
    const auto there = lanesUpTo(d, packet * kPacketRays + i, batch.rays);
    hn::Store(hn::Mul(near, hn::Set(d, 1 - hal::kSlack)), d, root.enter + i);
    hn::Store(hn::IfThenElse(there, hn::Mul(far, hn::Set(d, 1 + hal::kSlack)), hn::Set(d, -kInfinity)), d,
              root.leave + i);
  }
}

// Lanes whose ray has a part in the cell that begins before what it has hit.
HWY_INLINE uint32_t lanesIn(const KdEntry &at, const float *t) {
  const D16 d;
  uint32_t bits = 0;
  for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) {
    const auto near = hn::Load(d, at.enter + i);
    bits |= bitsOf(d, hn::And(hn::Le(near, hn::Load(d, at.leave + i)), hn::Le(near, hn::Load(d, t + i)))) << i;
  }
  return bits;
}

// Shares the parts out to the children, as the scalar unit does ray by ray. `at` becomes the child that ray `lane`
// meets first, `second` the other one. Returns whether any ray has a part in that.
HWY_INLINE bool descend(const hal::KdNode8 &node, const float *origins, const float *inverses, size_t lane, KdEntry &at,
                        KdEntry &second) {
  const D16 d;
  const bool isLeftFirst = hal::meetsLeftFirst(node, origins[lane], inverses[lane]);
  second.node = isLeftFirst ? node.right() : at.node + 1;
  at.node = isLeftFirst ? at.node + 1 : node.right();
  const auto split = hn::Set(d, node.split), none = hn::Set(d, -kInfinity);
  bool some = false;
  for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) {
    const auto origin = hn::LoadU(d, origins + i), inverse = hn::Load(d, inverses + i);
    const auto enter = hn::Load(d, at.enter + i), leave = hn::Load(d, at.leave + i);
    const auto t = hn::Mul(hn::Sub(split, origin), inverse);
    const auto early = hn::Mul(t, hn::Set(d, 1 - hal::kSlack)), late = hn::Mul(t, hn::Set(d, 1 + hal::kSlack));
    const auto onPlane = hn::And(hn::Eq(origin, split), hn::Ge(inverse, hn::Zero(d)));
    const auto leftFirst = hn::Or(hn::Lt(origin, split), onPlane);
    const auto sameOrder = isLeftFirst ? leftFirst : hn::Not(leftFirst);
    const auto nearOnly = hn::Or(hn::Lt(t, hn::Zero(d)), hn::Gt(early, leave));
    const auto farOnly = hn::AndNot(nearOnly, hn::Lt(late, enter));
    const auto nearLeave = hn::IfThenElse(nearOnly, leave, hn::IfThenElse(farOnly, none, hn::Min(leave, late)));
    const auto farEnter = hn::IfThenElse(farOnly, enter, hn::Max(enter, early));
    const auto farLeave = hn::IfThenElse(nearOnly, none, leave);
    const auto secondEnter = hn::IfThenElse(sameOrder, farEnter, enter);
    const auto secondLeave = hn::IfThenElse(sameOrder, farLeave, nearLeave);
    hn::Store(hn::IfThenElse(sameOrder, enter, farEnter), d, at.enter + i);
    hn::Store(hn::IfThenElse(sameOrder, nearLeave, farLeave), d, at.leave + i);
    hn::Store(secondEnter, d, second.enter + i);
    hn::Store(secondLeave, d, second.leave + i);
    some |= !hn::AllFalse(d, hn::Le(secondEnter, secondLeave));
  }
  return some;
}

// The triangles of a leaf against a packet.
template <bool kAny, bool kCommon>
HWY_INLINE void intersectLeaf(const Geometry &geometry, std::span<const uint32_t> primitives, Batch &batch,
                              size_t packet) {
  TriangleLanes triangles;
  for (const uint32_t primitive : primitives) {
    setTriangle<kCommon>(geometry, batch, primitive, triangles);
    intersectPacket<kAny, kCommon>(geometry, batch, triangles, 0, packet);
  }
}

template <bool kAny, bool kCommon>
HWY_NOINLINE void walkKdTree(const Geometry &geometry, Batch &batch, size_t packet) {
  const hal::AccelView &accel = geometry.view.accel;
  const size_t begin = packet * kPacketRays;
  KdRays rays;
  setUp(batch, packet, rays);
  KdEntry stack[hal::kMaxTreeDepth], at;
  enter(accel, batch, packet, rays, at);
  for (size_t depth = 0;;) {
    const hal::KdNode8 &node = accel.kdNodes[at.node];
    const uint32_t active = lanesIn(at, batch.t + begin);
    if (active && !node.isLeaf()) {
      const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(active);
      const uint32_t axis = node.axis();
      depth += descend(node, batch.origin[axis] + begin, rays.inverse[axis], lane, at, stack[depth]);
      continue;
    }
    if (active) {
      intersectLeaf<kAny, kCommon>(geometry, accel.primitives.subspan(node.offset, node.count()), batch, packet);
    }
    if (depth == 0) return;
    at = stack[--depth];
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
