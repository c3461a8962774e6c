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

// The same of a packet as seen from where the rays meet: a window of slopes, relative to the middle of the beam's, that
// is wider by kXShift / |z| at depth z, since the rays do not quite meet.
enum WindowBound { kXMiddle, kXHalf, kXShift, kYMiddle, kYHalf, kYShift, kFirst, kLast, kWindowBounds };

struct alignas(64) Beam {
  float windows[kWindowBounds][kPackets];  // what a lane without a packet has, nothing meets
  float window[kWindowBounds];             // of all packets
  float all[kBounds];
  float zSign, zOffset;                // depth = zSign * world + zOffset grows along the rays
  float xMeet, yMeet, xSlope, ySlope;  // where the rays meet at depth 0; the middle of their slopes
  size_t first, last;                  // packets
};

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

// The beam of all packets in every lane.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void broadcast(D d, const Beam &beam, V (&lanes)[kBounds]) {
  for (size_t k = 0; k < kBounds; ++k) lanes[k] = hn::Set(d, beam.all[k]);
}

// The farthest depth that rays of a packet have still to look at.
HWY_INLINE float farthest(const Batch &batch, const Beam &beam, size_t packet) {
  const D16 d;
  auto most = hn::Set(d, -kInfinity);
  const auto sign = hn::Set(d, beam.zSign), offset = hn::Set(d, beam.zOffset);
  for (size_t i = packet * kPacketRays; i < (packet + 1) * kPacketRays; i += hn::Lanes(d)) {
    const auto start = hn::MulAdd(hn::LoadU(d, batch.origin[batch.kz] + i), sign, offset);
    const auto speed = hn::Abs(hn::LoadU(d, batch.direction[batch.kz] + i));
    const auto length = hn::Mul(hn::Mul(hn::Load(d, batch.t + i), speed), hn::Set(d, 1 + hal::kSlack));
    most = hn::Max(most, hn::Add(start, length));
  }
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

// After hits of the packets whose bits are set.
HWY_INLINE void shorten(const Batch &batch, uint32_t changed, Beam &beam) {
  while (changed) {
    const size_t packet = nextBit(changed);
    beam.windows[kLast][packet] = farthest(batch, beam, packet);
  }
  const D16 d;
  auto most = hn::Set(d, -kInfinity);
  for (size_t p = 0; p < kPackets; p += hn::Lanes(d)) most = hn::Max(most, hn::Load(d, beam.windows[kLast] + p));
  beam.all[kFar] = beam.window[kLast] = hn::GetLane(hn::MaxOfLanes(d, most));
}

// Smallest and largest value.
template <class V>
struct Range {
  V least, most;

  HWY_INLINE void add(V v) {
    least = hn::Min(least, v);
    most = hn::Max(most, v);
  }
};

// Depth, by zSign alone, of the point that two rays of the range come closest to each other at. Nothing to gain: not
// a number. (The first and the last ray of a tile are far apart.)
inline float waist(const Batch &batch, float zSign, size_t i, size_t j) {
  const float *ox = batch.origin[batch.kx], *oy = batch.origin[batch.ky], *oz = batch.origin[batch.kz];
  const float sx = zSign * (batch.sx[i] - batch.sx[j]), sy = zSign * (batch.sy[i] - batch.sy[j]);
  const float bx = (ox[i] - batch.sx[i] * oz[i]) - (ox[j] - batch.sx[j] * oz[j]);
  const float by = (oy[i] - batch.sy[i] * oz[i]) - (oy[j] - batch.sy[j] * oz[j]);
  return -(bx * sx + by * sy) / (sx * sx + sy * sy);
}

struct DepthRange {
  float start, end;  // by zSign alone
};
HWY_INLINE DepthRange depthRange(const Batch &batch, float zSign, size_t first, size_t last) {
  const D16 d;
  auto start = hn::Set(d, kInfinity), end = hn::Set(d, -kInfinity);
  for (size_t i = first * kPacketRays; i < last * kPacketRays; i += hn::Lanes(d)) {
    const auto z = hn::Mul(hn::LoadU(d, batch.origin[batch.kz] + i), hn::Set(d, zSign));
    const auto speed = hn::Abs(hn::LoadU(d, batch.direction[batch.kz] + i));
    start = hn::Min(start, z);
    end = hn::Max(end, hn::MulAdd(hn::Load(d, batch.t + i), speed, z));
  }
  return {hn::GetLane(hn::MinOfLanes(d, start)), hn::GetLane(hn::MaxOfLanes(d, end))};
}

// Puts depth 0 where the rays meet; if that is amid them, where the first one starts. Returns whether all rays lie
// before it, as rays to a light do; if not, all lie behind.
HWY_INLINE bool placeOrigin(const Batch &batch, float extent, Beam &beam) {
  const size_t i = beam.first * kPacketRays, j = std::min(beam.last * kPacketRays, batch.rays) - 1;
  if (batch.common) {
    beam.zOffset = -beam.zSign * batch.origin[batch.kz][i];
    return false;
  }
  const DepthRange range = depthRange(batch, beam.zSign, beam.first, beam.last);
  const float z = waist(batch, beam.zSign, i, j);
  const bool useful = std::abs(z - range.start) < 64 * extent;  // beyond, rounding eats what is gained
  beam.zOffset = useful ? -z : -range.start;
  if (useful && z >= range.end - 1e-3f * (range.end - range.start)) return true;
  if (useful && z > range.start) beam.zOffset = -range.start;
  return false;
}

// The largest absolute coordinate of origins: what rounding errors grow with.
HWY_INLINE float magnitude(const Batch &batch, size_t first, size_t last) {
  const D16 d;
  auto most = hn::Zero(d);
  const size_t begin = first * kPacketRays, end = batch.common ? begin + kPacketRays : last * kPacketRays;
  for (const float *column : batch.origin) {
    for (size_t i = begin; i < end; i += hn::Lanes(d)) most = hn::Max(most, hn::Abs(hn::LoadU(d, column + i)));
  }
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

// The hull of one packet: intervals of slopes, of offsets at depth 0, and of depths.
struct Hull {
  float xSlope[2]{}, ySlope[2]{}, x[2]{}, y[2]{}, near = 0, far = 0;
};
HWY_INLINE Hull enclose(const Batch &batch, const Beam &beam, size_t packet, bool endless) {
  const D16 d;
  using V = hn::Vec<D16>;
  const V none = hn::Set(d, kInfinity), sign = hn::Set(d, beam.zSign);
  Range<V> sx{none, hn::Neg(none)}, sy = sx, cx = sx, cy = sx, start = sx;
  for (size_t i = packet * kPacketRays; i < (packet + 1) * kPacketRays; i += hn::Lanes(d)) {
    const V slopeX = hn::Mul(hn::Load(d, batch.sx + i), sign), slopeY = hn::Mul(hn::Load(d, batch.sy + i), sign);
    sx.add(slopeX);
    sy.add(slopeY);
    if (batch.common) continue;
    const V z = hn::MulAdd(hn::LoadU(d, batch.origin[batch.kz] + i), sign, hn::Set(d, beam.zOffset));
    start.add(z);
    cx.add(hn::NegMulAdd(slopeX, z, hn::LoadU(d, batch.origin[batch.kx] + i)));
    cy.add(hn::NegMulAdd(slopeY, z, hn::LoadU(d, batch.origin[batch.ky] + i)));
  }
  Hull hull;
  hull.xSlope[0] = hn::GetLane(hn::MinOfLanes(d, sx.least));
  hull.xSlope[1] = hn::GetLane(hn::MaxOfLanes(d, sx.most));
  hull.ySlope[0] = hn::GetLane(hn::MinOfLanes(d, sy.least));
  hull.ySlope[1] = hn::GetLane(hn::MaxOfLanes(d, sy.most));
  hull.far = endless ? kInfinity : farthest(batch, beam, packet);
  if (batch.common) {
    const size_t i = packet * kPacketRays;
    hull.x[0] = hull.x[1] = batch.origin[batch.kx][i];
    hull.y[0] = hull.y[1] = batch.origin[batch.ky][i];
    hull.near = 0;
    return hull;
  }
  hull.x[0] = hn::GetLane(hn::MinOfLanes(d, cx.least));
  hull.x[1] = hn::GetLane(hn::MaxOfLanes(d, cx.most));
  hull.y[0] = hn::GetLane(hn::MinOfLanes(d, cy.least));
  hull.y[1] = hn::GetLane(hn::MaxOfLanes(d, cy.most));
  hull.near = hn::GetLane(hn::MinOfLanes(d, start.least));
  return hull;
}

HWY_INLINE void unite(Hull &all, const Hull &hull) {
  all.near = std::min(all.near, hull.near);
  all.far = std::max(all.far, hull.far);
  for (float(Hull::*bounds)[2] : {&Hull::xSlope, &Hull::ySlope, &Hull::x, &Hull::y}) {
    (all.*bounds)[0] = std::min((all.*bounds)[0], (hull.*bounds)[0]);
    (all.*bounds)[1] = std::max((all.*bounds)[1], (hull.*bounds)[1]);
  }
}

constexpr float kSlopeMargin = 0x1p-20f;

// before: the rays lie at negative depths, where slopes count the other way round.
inline void setBounds(const Hull &hull, bool before, float margin, Beam &beam) {
  const float x = hull.xSlope[1] - hull.xSlope[0], y = hull.ySlope[1] - hull.ySlope[0];
  // Rounding, or a light at hand, may lead rays beyond depth 0.
  const float beyond = before ? std::max(hull.far, 0.0f) : 0;
  beam.all[kXUpper] = hull.x[1] + margin + beyond * x;
  beam.all[kXLower] = hull.x[0] - margin - beyond * x;
  beam.all[kYUpper] = hull.y[1] + margin + beyond * y;
  beam.all[kYLower] = hull.y[0] - margin - beyond * y;
  beam.all[before ? kXLowerSlope : kXUpperSlope] = hull.xSlope[1] + kSlopeMargin;
  beam.all[before ? kXUpperSlope : kXLowerSlope] = hull.xSlope[0] - kSlopeMargin;
  beam.all[before ? kYLowerSlope : kYUpperSlope] = hull.ySlope[1] + kSlopeMargin;
  beam.all[before ? kYUpperSlope : kYLowerSlope] = hull.ySlope[0] - kSlopeMargin;
  beam.all[kNear] = hull.near - margin;
  beam.all[kFar] = hull.far + margin;
}

HWY_INLINE void setWindow(const Hull &hull, const Beam &beam, float margin, float *window, size_t stride) {
  window[kXMiddle * stride] = (hull.xSlope[0] + hull.xSlope[1]) * 0.5f - beam.xSlope;
  window[kXHalf * stride] = (hull.xSlope[1] - hull.xSlope[0]) * 0.5f + kSlopeMargin;
  window[kXShift * stride] = std::max(hull.x[1] - beam.xMeet, beam.xMeet - hull.x[0]) + margin;
  window[kYMiddle * stride] = (hull.ySlope[0] + hull.ySlope[1]) * 0.5f - beam.ySlope;
  window[kYHalf * stride] = (hull.ySlope[1] - hull.ySlope[0]) * 0.5f + kSlopeMargin;
  window[kYShift * stride] = std::max(hull.y[1] - beam.yMeet, beam.yMeet - hull.y[0]) + margin;
  window[kFirst * stride] = hull.near - margin;
  window[kLast * stride] = hull.far + margin;
}

// The hull of packets [first, last). extent: of the scene. endless: no ray has an end yet.
HWY_INLINE void makeBeam(const Batch &batch, size_t first, size_t last, float extent, bool endless, Beam &beam) {
  beam.first = first;
  beam.last = last;
  beam.zSign = batch.direction[batch.kz][first * kPacketRays] < 0 ? -1.0f : 1.0f;
  const bool before = placeOrigin(batch, extent, beam);
  const float margin = 0x1p-20f * std::max(std::abs(beam.zOffset), magnitude(batch, first, last));
  Hull hulls[kPackets], all;
  for (size_t p = first; p < last; ++p) {
    hulls[p] = enclose(batch, beam, p, endless);
    if (p == first) all = hulls[p];
    unite(all, hulls[p]);
  }
  setBounds(all, before, margin, beam);
  beam.xMeet = (all.x[0] + all.x[1]) * 0.5f;
  beam.yMeet = (all.y[0] + all.y[1]) * 0.5f;
  beam.xSlope = (all.xSlope[0] + all.xSlope[1]) * 0.5f;
  beam.ySlope = (all.ySlope[0] + all.ySlope[1]) * 0.5f;
  setWindow(all, beam, margin, beam.window, 1);
  for (size_t p = 0; p < kPackets; ++p) {
    if (p >= first && p < last) {
      setWindow(hulls[p], beam, margin, &beam.windows[0][p], kPackets);
    } else {
      for (auto &bound : beam.windows) bound[p] = 0;
      beam.windows[kLast][p] = -kInfinity;
    }
  }
}

// The widest the beam gets within the bounds, as a share of their extent: how incoherent its rays are.
inline float spread(const Batch &batch, const Beam &beam, const Bounds &bounds, float extent) {
  const float a = beam.zSign * bounds.lower[batch.kz] + beam.zOffset;
  const float b = beam.zSign * bounds.upper[batch.kz] + beam.zOffset;
  const float z = std::max(std::abs(std::clamp(a, beam.all[kNear], std::max(beam.all[kNear], beam.all[kFar]))),
                           std::abs(std::clamp(b, beam.all[kNear], std::max(beam.all[kNear], beam.all[kFar]))));
  const float x = beam.all[kXUpper] - beam.all[kXLower] + z * std::abs(beam.all[kXUpperSlope] - beam.all[kXLowerSlope]);
  const float y = beam.all[kYUpper] - beam.all[kYLower] + z * std::abs(beam.all[kYUpperSlope] - beam.all[kYLowerSlope]);
  return std::max(x, y) / extent;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
