// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// beam_walk-inl.h: packets through the BVH behind one beam. A node costs one test of its children's boxes for all
// rays, and one for all packets of each child that is met; the triangles of four leaves at a time are tested with those
// packets whose windows they may be seen through.
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

using BeamEntry = LanesEntryOf<kPackets>;

inline constexpr hal::TriangleBlock4 kEmptyBlock = [] {
  hal::TriangleBlock4 block{};
  for (uint32_t &primitive : block.primitive) primitive = hal::TriangleBlock4::kNone;
  return block;
}();

// Leaves that wait until there are triangles for all lanes.
struct WaitingLeaves {
  Blocks blocks;  // on their way into the cache
  size_t count = 0;
  uint32_t packets = 0;  // that meet the box of a leaf
  size_t tests = 0;      // of a triangle with a packet, so far
};

// Where the packets of the beam meet the box of a child; infinity if they do not.
HWY_INLINE void meetPackets(const hal::BvhNode8 &node, uint32_t child, const Batch &batch, const Beam &beam,
                            const float *entered, float *near) {
  const D16 d;
  using V = hn::Vec<D16>;
  const V sign = hn::Set(d, batch.zSign), offset = hn::Set(d, beam.zOffset);
  const auto &x = node.planes[batch.kx], &y = node.planes[batch.ky], &z = node.planes[batch.kz];
  const int front = batch.zSign < 0;
  for (size_t i = 0; i < kPackets; i += hn::Lanes(d)) {
    V lanes[kBounds];
    for (size_t k = 0; k < kBounds; ++k) lanes[k] = hn::Load(d, beam.bounds[k] + i);
    lanes[kNear] = hn::Max(lanes[kNear], hn::Load(d, entered + i));
    BoxLanes<V> box{hn::Set(d, x[0][child]),
                    hn::Set(d, x[1][child]),
                    hn::Set(d, y[0][child]),
                    hn::Set(d, y[1][child]),
                    hn::MulAdd(hn::Set(d, z[front][child]), sign, offset),
                    hn::MulAdd(hn::Set(d, z[!front][child]), sign, offset)};
    const auto met = meets(d, box, lanes);
    hn::Store(hn::IfThenElse(met, box.near, hn::Set(d, kInfinity)), d, near + i);
  }
}

// Puts the children that the beam meets onto the stack, nearer ones later: one test for all of them, then one of each
// for all packets. That none of these meets a child is so rare that it is left to be found out when it comes off again.
HWY_INLINE size_t pushChildren(const hal::AccelView &accel, const hal::BvhNode8 &node, const Batch &batch,
                               const Beam &beam, const float *entered, BeamEntry *stack, size_t depth) {
  const D8 d;
  using V = hn::Vec<D8>;
  V lanes[kBounds];
  for (size_t k = 0; k < kBounds; ++k) lanes[k] = hn::Set(d, beam.all[k]);
  const V sign = hn::Set(d, batch.zSign), offset = hn::Set(d, beam.zOffset);
  const auto &x = node.planes[batch.kx], &y = node.planes[batch.ky], &z = node.planes[batch.kz];
  const int front = batch.zSign < 0;
  alignas(32) float keys[hal::BvhNode8::kWidth];
  uint32_t met = 0;
  for (size_t i = 0; i < hal::BvhNode8::kWidth; i += hn::Lanes(d)) {
    BoxLanes<V> box{hn::Load(d, x[0] + i),
                    hn::Load(d, x[1] + i),
                    hn::Load(d, y[0] + i),
                    hn::Load(d, y[1] + i),
                    hn::MulAdd(hn::Load(d, z[front] + i), sign, offset),
                    hn::MulAdd(hn::Load(d, z[!front] + i), sign, offset)};
    met |= bitsOf(d, meets(d, box, lanes)) << i;
    hn::Store(box.near, d, keys + i);
  }
  for (uint32_t bits = met; bits;) {
    const uint32_t child = nextBit(bits);
    prefetch(accel, node.child[child]);
    BeamEntry &entry = stack[depth + countBeneath(keys, met, child)];
    entry.child = node.child[child];
    meetPackets(node, child, batch, beam, entered, entry.near);
  }
  return depth + hwy::PopCount(met);
}

// Packets and triangles that may concern each other, as one list: where it ends is foretold wrong but once, where loops
// over the few triangles of each packet end, again and again.
class Pairs {
 public:
  struct Pair {
    size_t packet, triangle;
  };

  size_t size() const { return mSize; }
  Pair operator[](size_t i) const { return {mItems[i] / kLanes, mItems[i] % kLanes}; }
  // The triangles of the mask, the first lane of which is `first`.
  HWY_INLINE void add(size_t packet, size_t first, hn::Mask<D16> triangles) {
    const hn::RebindToUnsigned<D16> du;
    const auto items = countFrom(du, packet * kLanes + first);
    hn::StoreU(packed(du, items, hn::RebindMask(du, triangles)), du, mItems + mSize);
    mSize += hn::CountTrue(D16(), triangles);
  }
  // stays(pair): whether.
  template <class Stays>
  HWY_INLINE void keepIf(Stays &&stays) {
    size_t kept = 0;
    for (size_t i = 0; i < mSize; ++i) {
      const uint32_t item = mItems[i];
      mItems[kept] = item;
      kept += stays((*this)[i]);
    }
    mSize = kept;
  }

 private:
  uint32_t mItems[(kPackets + 1) * kLanes];  // packet * kLanes + triangle; room for a vector
  size_t mSize = 0;
};

// What single rays are asked with: their slopes; NaN for those that are blocked, which then meet nothing.
struct alignas(64) RaySlopes {
  float x[kBatchRays], y[kBatchRays];
};
HWY_INLINE void setSlopes(const Batch &batch, const Beam &beam, size_t packet, RaySlopes &out) {
  const D16 d;
  const auto sign = hn::Set(d, batch.zSign), x = hn::Set(d, beam.xSlope), y = hn::Set(d, beam.ySlope);
  const auto none = hn::NaN(d);
  for (size_t k = 0; k < kPacketRays; k += hn::Lanes(d)) {
    const size_t i = packet * kPacketRays + k;
    const auto open = hn::Gt(hn::Load(d, batch.t + i), hn::Zero(d));
    hn::Store(hn::IfThenElse(open, hn::MulSub(hn::Load(d, batch.sx + i), sign, x), none), d, out.x + i);
    hn::Store(hn::IfThenElse(open, hn::MulSub(hn::Load(d, batch.sy + i), sign, y), none), d, out.y + i);
  }
}

// Whether some ray of the packet may meet the triangle: one that is not blocked yet and is not about it itself. Of what
// a window holds, shadow rays miss more than half, and so do others where triangles are smaller than packets; finding
// that out here costs a third of the test.
HWY_INLINE bool seenByRays(const TriangleLanes &triangles, const Outlines &outlines, const Batch &batch,
                           const RaySlopes &slopes, size_t packet, size_t triangle) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  bool seen = false;
  for (size_t k = 0; k < kPacketRays; k += hn::Lanes(d)) {
    const size_t i = packet * kPacketRays + k;
    auto may = mayMeet(outlines, triangle, hn::Load(d, slopes.x + i), hn::Load(d, slopes.y + i));
    if (batch.from) {
      const auto other = hn::Ne(hn::LoadU(du, batch.from + i), hn::Set(du, triangles.primitive[triangle]));
      may = hn::And(may, hn::RebindMask(d, other));
    }
    seen |= !hn::AllFalse(d, may);
  }
  return seen;
}

// The triangles that wait.
template <bool kAny, bool kCommon>
HWY_INLINE void intersectLeaves(const Geometry &geometry, Batch &batch, Beam &beam, WaitingLeaves &leaves) {
  const D16 d;
  TriangleLanes triangles;
  for (size_t i = leaves.count; i < kBlocks; ++i) leaves.blocks[i] = &kEmptyBlock;
  setTriangles(geometry, leaves.blocks, batch, triangles);
  Outlines outlines;
  outline(triangles, batch, beam, outlines);
  Pairs pairs;
  RaySlopes slopes;
  while (leaves.packets) {
    const uint32_t packet = nextBit(leaves.packets);
    if (beam.asksRays) setSlopes(batch, beam, packet, slopes);
    for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) pairs.add(packet, i, trianglesIn(outlines, beam, packet, i));
  }
  leaves.tests += pairs.size();
  if (beam.asksRays) {
    pairs.keepIf([&](const Pairs::Pair &pair)
                     HWY_ATTR { return seenByRays(triangles, outlines, batch, slopes, pair.packet, pair.triangle); });
  }
  uint32_t tested = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const auto [packet, triangle] = pairs[i];
    intersectPacket<kAny, kCommon>(geometry, batch, triangles, triangle, packet);
    tested |= 1u << packet;
  }
  shorten(batch, tested, beam);
  leaves.count = 0;
}

// So many triangles, on average, may be tested with a packet until its rays go alone. Measured with bench/trace.
constexpr size_t kMostTests = 128;

// Returns false if the rays turn out to have too little in common; what they have found by then counts.
template <bool kAny, bool kCommon>
HWY_NOINLINE bool walkWithBeam(const Geometry &geometry, Batch &batch, Beam &beam) {
  const hal::AccelView &accel = geometry.view.accel;
  WaitingLeaves leaves;
  alignas(64) float entered[kPackets];
  BeamEntry stack[hal::kMaxBvhStack];
  for (size_t p = 0; p < kPackets; ++p) stack[0].near[p] = beam.packets >> p & 1 ? -kFarthest : kInfinity;
  stack[0].child = 0;
  size_t depth = 1;
  const size_t mostTests = kMostTests * hwy::PopCount(beam.packets);
  while (leaves.tests <= mostTests) {
    uint32_t packets = 0;
    while (depth > 0 && !packets) packets = lanesBefore(stack[--depth].near, beam.bounds[kFar]);
    if (!packets) {
      if (leaves.count == 0) return true;
      intersectLeaves<kAny, kCommon>(geometry, batch, beam, leaves);
      continue;
    }
    const BeamEntry &at = stack[depth];
    if (at.child & hal::BvhNode8::kLeaf) {
      leaves.blocks[leaves.count++] = &accel.blocks[at.child & ~hal::BvhNode8::kLeaf];
      leaves.packets |= packets;
      if (leaves.count == kBlocks) intersectLeaves<kAny, kCommon>(geometry, batch, beam, leaves);
    } else {
      std::memcpy(entered, at.near, sizeof entered);
      depth = pushChildren(accel, accel.bvhNodes[at.child], batch, beam, entered, stack, depth);
    }
  }
  return false;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
