// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// beam-inl.h: the hull of the rays of packets, and of all of a batch: what boxes are tested against together.
// A ray of a batch is a line x = c + s z. Over rays, c and s lie in intervals, so that at each depth z the hull is an
// axis-parallel rectangle (interval arithmetic as in Boulos, Wald, Shirley: "Geometric and Arithmetic Culling Methods
// for Entire Ray Packets", 2006). Where z = 0 is, is free: at the point where the rays meet, an eye, a light or the
// mirror image of one, the interval of c vanishes and the hull is as narrow as a frustum.
#if defined(RAYCORE_KERNELS_BEAM_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_BEAM_INL
#undef RAYCORE_KERNELS_BEAM_INL
#else
#define RAYCORE_KERNELS_BEAM_INL
#endif

#include "rcddi/cpu/kernels/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Bounds of c and s over all rays. upper: where |z| grows along the slope that leads farthest up; lower: farthest down.
enum Bound {
  kXUpper,
  kXUpperSlope,
  kXLower,
  kXLowerSlope,
  kYUpper,
  kYUpperSlope,
  kYLower,
  kYLowerSlope,
  kNear,
  kFar,
  kBounds
};

// What a packet looks through as seen from where the rays meet: a window of slopes, relative to the middle of the
// beam's, that is wider by kXShift / |z| at depth z, since the rays do not quite meet.
enum WindowBound { kXMiddle, kXHalf, kXShift, kYMiddle, kYHalf, kYShift, kWindowBounds };

struct alignas(64) Beam {
  float bounds[kBounds][kPackets];  // what a lane without a packet has, nothing meets
  float windows[kWindowBounds][kPackets];
  float all[kBounds];                  // of all packets
  float zOffset;                       // depth = batch.zSign * world + zOffset grows along the rays
  float xMeet, yMeet, xSlope, ySlope;  // where the rays meet at depth 0; the middle of their slopes
  float side;                          // the sign of the depths at which rays lie, as far as that can be said
  float rounding;                      // of coordinates from where the rays meet
  uint32_t packets;                    // a bit for each that takes part
  bool asksRays;                       // triangles are small: single rays tell which of them a packet is tested with

  // How far rays go by the point where they meet, and beyond it.
  float reach() const {
    const float by = 0.5f * std::max(all[kXUpper] - all[kXLower], all[kYUpper] - all[kYLower]);
    return by + 2 * std::max(side < 0 ? all[kFar] : -all[kNear], 0.0f);
  }
};

constexpr float kSlopeMargin = 0x1p-20f;

// A box by planes; z is depth.
template <class V>
struct BoxLanes {
  V xLower, xUpper, yLower, yUpper, near, far;
};

// Lanes where box and beam meet; `near` becomes where.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets(D, BoxLanes<V> &box, const V (&beam)[kBounds]) {
  box.near = hn::Max(box.near, beam[kNear]);
  const V far = hn::Min(box.far, beam[kFar]);
  const auto z = hn::Le(box.near, far);
  const V xUpper =
      hn::Add(beam[kXUpper], hn::Max(hn::Mul(beam[kXUpperSlope], box.near), hn::Mul(beam[kXUpperSlope], far)));
  const V xLower =
      hn::Add(beam[kXLower], hn::Min(hn::Mul(beam[kXLowerSlope], box.near), hn::Mul(beam[kXLowerSlope], far)));
  const auto x = hn::And(hn::Le(box.xLower, xUpper), hn::Ge(box.xUpper, xLower));
  const V yUpper =
      hn::Add(beam[kYUpper], hn::Max(hn::Mul(beam[kYUpperSlope], box.near), hn::Mul(beam[kYUpperSlope], far)));
  const V yLower =
      hn::Add(beam[kYLower], hn::Min(hn::Mul(beam[kYLowerSlope], box.near), hn::Mul(beam[kYLowerSlope], far)));
  const auto y = hn::And(hn::Le(box.yLower, yUpper), hn::Ge(box.yUpper, yLower));
  return hn::And(z, hn::And(x, y));
}

// The depths that the rays from i on have still to look at.
HWY_INLINE hn::Vec<D16> endsOf(const Batch &batch, const Beam &beam, size_t i) {
  const D16 d;
  const auto start =
      hn::MulAdd(hn::LoadU(d, batch.origin[batch.kz] + i), hn::Set(d, batch.zSign), hn::Set(d, beam.zOffset));
  const auto speed = hn::Abs(hn::LoadU(d, batch.direction[batch.kz] + i));
  const auto length = hn::Mul(hn::Mul(hn::Load(d, batch.t + i), speed), hn::Set(d, 1 + hal::kSlack));
  return hn::Min(hn::Add(start, length), hn::Set(d, kFarthest));
}

// After what may be hits of the packets whose bits are set, four at a time.
HWY_INLINE void shorten(const Batch &batch, uint32_t packets, Beam &beam) {
  const D16 d;
  while (packets) {
    size_t packet[4];
    hn::Vec<D16> ends[4];
    for (size_t k = 0; k < 4; ++k) {
      packet[k] = packets ? nextBit(packets) : packet[k - 1];
      const size_t first = packet[k] * kPacketRays;
      ends[k] = endsOf(batch, beam, first);
      for (size_t i = hn::Lanes(d); i < kPacketRays; i += hn::Lanes(d)) {
        ends[k] = hn::Max(ends[k], endsOf(batch, beam, first + i));
      }
    }
    float farthest[4];
    storeBest(d, Most(), ends, farthest);
    for (size_t k = 0; k < 4; ++k) beam.bounds[kFar][packet[k]] = farthest[k] + beam.rounding;
  }
  auto most = hn::Set(d, -kInfinity);
  for (size_t p = 0; p < kPackets; p += hn::Lanes(d)) most = hn::Max(most, hn::Load(d, beam.bounds[kFar] + p));
  beam.all[kFar] = hn::GetLane(hn::MaxOfLanes(d, most));
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
