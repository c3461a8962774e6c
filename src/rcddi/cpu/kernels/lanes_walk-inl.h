// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lanes_walk-inl.h: the rays of a packet through the BVH side by side, each in a lane of its own. A box is tested
// with all of them, and only those that meet it go on; a ray that is left alone is walked alone.
// For rays that start near each other and go their own ways: they have the upper tree and what lies around their
// origins in common. The near distances of each lane wait on the stack, so that rays with a hit drop out one by one.
// Benthin, Wald, Woop, Ernst, Mark: "Combining Single and Packet-Ray Tracing for Arbitrary Ray Distributions on the
// Intel MIC Architecture", TVCG 18(9), 2012.
#if defined(RAYCORE_KERNELS_LANES_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_LANES_WALK_INL
#undef RAYCORE_KERNELS_LANES_WALK_INL
#else
#define RAYCORE_KERNELS_LANES_WALK_INL
#endif

#include "rcddi/cpu/kernels/single-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// So many rays, or fewer, are walked one by one: more where side by side takes several vectors. Measured with
// bench/trace.
constexpr size_t kFewRays = HWY_MAX_BYTES >= 64 ? 2 : 4;

// Where the rays meet the boxes of a node's children.
struct alignas(64) ChildrenMet {
  float near[hal::BvhNode8::kWidth][kLanes];  // infinity: the lane does not
  uint32_t met = 0;                           // a bit for each child that some lane meets
};

// Along which axes the rays of a packet run backwards. Not mixed: all do, or none does.
struct Headings {
  size_t backwards[3];
  bool mixed = false;
};
HWY_INLINE Headings headingsOf(const SlabRays &rays) {
  const D16 d;
  Headings out;
  for (size_t axis = 0; axis < 3; ++axis) {
    uint32_t lanes = 0;
    for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
      lanes |= bitsOf(d, hn::Lt(hn::Load(d, rays.nearInverse[axis] + i), hn::Zero(d))) << i;
    }
    out.backwards[axis] = lanes & 1;
    out.mixed |= lanes != 0 && lanes != (1u << kPacketRays) - 1;
  }
  return out;
}

// There is no branch on a single child: it cannot be foretold.
template <bool kMixed>
HWY_INLINE ChildrenMet meetChildren(const hal::BvhNode8 &node, const SlabRays &rays, const Headings &headings,
                                    const float *entered, const float *end) {
  const D16 d;
  using V = hn::Vec<D16>;
  ChildrenMet out;
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
    V nearInverse[3], nearStart[3], farInverse[3], farStart[3];
    hn::Mask<D16> backwards[3];
    const float *first[3], *last[3];  // planes: of rays that run forwards, if they are mixed
    for (size_t axis = 0; axis < 3; ++axis) {
      nearInverse[axis] = hn::Load(d, rays.nearInverse[axis] + i);
      nearStart[axis] = hn::Load(d, rays.nearStart[axis] + i);
      farInverse[axis] = hn::Load(d, rays.farInverse[axis] + i);
      farStart[axis] = hn::Load(d, rays.farStart[axis] + i);
      backwards[axis] = hn::Lt(nearInverse[axis], hn::Zero(d));
      first[axis] = node.planes[axis][kMixed ? 0 : headings.backwards[axis]];
      last[axis] = node.planes[axis][kMixed ? 1 : 1 - headings.backwards[axis]];
    }
    for (uint32_t child = 0; child < hal::BvhNode8::kWidth; ++child) {
      V near = hn::Load(d, entered + i), far = hn::Load(d, end + i);
      for (size_t axis = 0; axis < 3; ++axis) {
        V from = hn::Set(d, first[axis][child]), to = hn::Set(d, last[axis][child]);
        if constexpr (kMixed) {
          const V lower = from;
          from = hn::IfThenElse(backwards[axis], to, from);
          to = hn::IfThenElse(backwards[axis], lower, to);
        }
        near = hn::Max(near, hn::MulSub(from, nearInverse[axis], nearStart[axis]));
        far = hn::Min(far, hn::MulSub(to, farInverse[axis], farStart[axis]));
      }
      const auto meets = hn::Le(near, far);
      out.met |= uint32_t(!hn::AllFalse(d, meets)) << child;
      hn::Store(hn::IfThenElse(meets, near, hn::Set(d, kInfinity)), d, out.near[child] + i);
    }
  }
  return out;
}

// Puts the children that are met onto the stack, nearest last, as one ray sees it.
HWY_INLINE size_t push(const hal::AccelView &accel, const hal::BvhNode8 &node, const ChildrenMet &children,
                       const SlabRay &ray, LanesEntry *stack, size_t depth) {
  alignas(32) float keys[hal::BvhNode8::kWidth];
  meets(node, ray, 0, keys);  // at whatever distance
  visitBits<2>(children.met, [&](uint32_t child) HWY_ATTR {
    prefetch(accel, node.child[child]);
    LanesEntry &entry = stack[depth + countBeneath(keys, children.met, child)];
    entry.child = node.child[child];
    std::memcpy(entry.near, children.near[child], sizeof entry.near);
  });
  return depth + hwy::PopCount(children.met);
}

// How far the rays of a packet have still to look.
HWY_INLINE void setEnds(const Batch &batch, size_t packet, float *end) {
  const D16 d;
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(d)) {
    const auto t = hn::Load(d, batch.t + packet * kPacketRays + i);
    hn::Store(hn::Min(hn::Mul(t, hn::Set(d, kFarther)), hn::Set(d, kFarthest)), d, end + i);
  }
}

// The triangles of a leaf one by one, each with all rays of a packet.
template <bool kAny>
HWY_INLINE void intersectTogether(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch,
                                  size_t packet) {
  TriangleLanes triangles;
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  for (size_t v = 0; v < 3; ++v) {
    for (size_t k = 0; k < 3; ++k) {
      std::memcpy(triangles.corners[v][k], block.vertices[v][axes[k]], sizeof block.vertices[v][k]);
    }
  }
  for (size_t lane = 0; lane < kBlockWidth && block.primitive[lane] != hal::TriangleBlock4::kNone; ++lane) {
    triangles.primitive[lane] = geometry.base + block.primitive[lane];
    intersectPacket<kAny, false>(geometry, batch, triangles, lane, packet);
  }
}

// Returns whether some ray may have got a better hit, or is blocked.
template <bool kAny>
HWY_INLINE bool intersectLeaf(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch, size_t packet,
                              uint32_t lanes) {
  constexpr uint32_t kAll = (1u << kPacketRays) - 1;
  if (lanes != kAll) return intersectBlock<kAny>(geometry, block, batch, packet, lanes);
  intersectTogether<kAny>(geometry, block, batch, packet);
  return true;
}

template <bool kAny>
HWY_NOINLINE void walkInLanes(const Geometry &geometry, Batch &batch, size_t packet) {
  const hal::AccelView &accel = geometry.view.accel;
  const size_t begin = packet * kPacketRays;
  alignas(64) float entered[kLanes], end[kLanes];
  SlabRays rays;
  setUp(batch, packet, rays);
  const Headings headings = headingsOf(rays);
  setEnds(batch, packet, end);
  LanesEntry stack[hal::kMaxBvhStack];
  for (size_t i = 0; i < kPacketRays; ++i) stack[0].near[i] = begin + i < batch.rays ? 0.0f : kInfinity;
  stack[0].child = 0;
  for (size_t depth = 1; depth > 0;) {
    const LanesEntry &at = stack[--depth];
    uint32_t active = lanesBefore(at.near, end);
    if (!active) continue;
    const uint32_t child = at.child;
    if (child & hal::BvhNode8::kLeaf) {
      const hal::TriangleBlock4 &block = accel.blocks[child & ~hal::BvhNode8::kLeaf];
      if (intersectLeaf<kAny>(geometry, block, batch, packet, active)) setEnds(batch, packet, end);
    } else if (hwy::PopCount(active) <= kFewRays) {
      while (active) walkAlone<kAny>(geometry, batch, rays, begin + nextBit(active), child);
      setEnds(batch, packet, end);
    } else {
      std::memcpy(entered, at.near, sizeof entered);
      const hal::BvhNode8 &node = accel.bvhNodes[child];
      const ChildrenMet children = headings.mixed ? meetChildren<true>(node, rays, headings, entered, end)
                                                  : meetChildren<false>(node, rays, headings, entered, end);
      const SlabRay first(rays, hwy::Num0BitsBelowLS1Bit_Nonzero32(active));
      depth = push(accel, node, children, first, stack, depth);
    }
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
