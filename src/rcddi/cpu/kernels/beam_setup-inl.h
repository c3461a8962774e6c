// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// beam_setup-inl.h: from the rays of a batch to its beam: where they meet, and the hull of each packet.
#if defined(RAYCORE_KERNELS_BEAM_SETUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_BEAM_SETUP_INL
#undef RAYCORE_KERNELS_BEAM_SETUP_INL
#else
#define RAYCORE_KERNELS_BEAM_SETUP_INL
#endif

#include "rcddi/cpu/kernels/hulls-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Depth, by zSign alone, of the point that two rays of the range come closest to each other at. Nothing to gain: not
// a number. (The first and the last ray of a tile are far apart.)
inline float waist(const Batch &batch, size_t i, size_t j) {
  const float *ox = batch.origin[batch.kx], *oy = batch.origin[batch.ky], *oz = batch.origin[batch.kz];
  const float sx = batch.zSign * (batch.sx[i] - batch.sx[j]), sy = batch.zSign * (batch.sy[i] - batch.sy[j]);
  const float bx = (ox[i] - batch.sx[i] * oz[i]) - (ox[j] - batch.sx[j] * oz[j]);
  const float by = (oy[i] - batch.sy[i] * oz[i]) - (oy[j] - batch.sy[j] * oz[j]);
  return -(bx * sx + by * sy) / (sx * sx + sy * sy);
}

// Puts depth 0 where the rays meet; if that is amid them, where the first one starts. Returns whether all rays lie
// before it, as rays to a light do; if not, all lie behind.
HWY_INLINE bool placeOrigin(const Batch &batch, float extent, Beam &beam) {
  if (batch.common) {
    beam.zOffset = -batch.zSign * batch.origin[batch.kz][0];
    return false;
  }
  const float z = waist(batch, 0, batch.rays - 1);
  const bool useful = std::abs(z - batch.start) < 64 * extent;  // beyond, rounding eats what is gained
  beam.zOffset = useful ? -z : -batch.start;
  if (useful && z >= batch.end - 1e-3f * (batch.end - batch.start)) return true;
  if (useful && z > batch.start) beam.zOffset = -batch.start;
  return false;
}

// before: the rays lie at negative depths, where slopes count the other way round.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void boundsOf(D d, const Hulls &hulls, size_t i, bool before, float margin, V (&out)[kBounds]) {
  const auto load = [&](const float *column) HWY_ATTR { return hn::Load(d, column + i); };
  const V wide = hn::Set(d, margin), slope = hn::Set(d, kSlopeMargin);
  const V xLess = hn::Sub(load(hulls.xSlope[0]), slope), xMore = hn::Add(load(hulls.xSlope[1]), slope);
  const V yLess = hn::Sub(load(hulls.ySlope[0]), slope), yMore = hn::Add(load(hulls.ySlope[1]), slope);
  // Rounding, or a light at hand, may lead rays beyond depth 0.
  const V beyond = before ? hn::Max(load(hulls.end), hn::Zero(d)) : hn::Zero(d);
  const V xMargin = hn::MulAdd(beyond, hn::Sub(xMore, xLess), wide);
  const V yMargin = hn::MulAdd(beyond, hn::Sub(yMore, yLess), wide);
  out[kXUpper] = hn::Add(load(hulls.x[1]), xMargin);
  out[kXLower] = hn::Sub(load(hulls.x[0]), xMargin);
  out[kYUpper] = hn::Add(load(hulls.y[1]), yMargin);
  out[kYLower] = hn::Sub(load(hulls.y[0]), yMargin);
  out[kXUpperSlope] = before ? xLess : xMore;
  out[kXLowerSlope] = before ? xMore : xLess;
  out[kYUpperSlope] = before ? yLess : yMore;
  out[kYLowerSlope] = before ? yMore : yLess;
  out[kNear] = hn::Sub(load(hulls.start), wide);
  out[kFar] = hn::Min(hn::Add(load(hulls.end), wide), hn::Set(d, kFarthest));
}

// The widest that packets get where most triangles are: how incoherent their rays are.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V spread(D d, const Batch &batch, const Beam &beam, const V (&bounds)[kBounds], const Bounds &core) {
  const V end = hn::Max(bounds[kNear], bounds[kFar]);
  V z = hn::Zero(d);
  for (const float plane : {core.lower[batch.kz], core.upper[batch.kz]}) {
    const V depth = hn::Set(d, batch.zSign * plane + beam.zOffset);
    z = hn::Max(z, hn::Abs(hn::Min(hn::Max(depth, bounds[kNear]), end)));
  }
  const V x = hn::Abs(hn::Sub(bounds[kXUpperSlope], bounds[kXLowerSlope]));
  const V y = hn::Abs(hn::Sub(bounds[kYUpperSlope], bounds[kYLowerSlope]));
  return hn::Max(hn::MulAdd(z, x, hn::Sub(bounds[kXUpper], bounds[kXLower])),
                 hn::MulAdd(z, y, hn::Sub(bounds[kYUpper], bounds[kYLower])));
}

// The bounds of all packets that take part.
HWY_INLINE void unite(bool before, Beam &beam) {
  const D16 d;
  // Of each bound the most is wanted, or, as the most of what it is less than 0, the least.
  const float slope = before ? -1 : 1;
  constexpr size_t kFours = (kBounds + 3) / 4;
  float signs[4 * kFours] = {}, most[4 * kFours];
  for (const auto &[bound, sign] : {std::pair{kXUpper, 1.0f},
                                    {kXUpperSlope, slope},
                                    {kXLower, -1},
                                    {kXLowerSlope, -slope},
                                    {kYUpper, 1},
                                    {kYUpperSlope, slope},
                                    {kYLower, -1},
                                    {kYLowerSlope, -slope},
                                    {kNear, -1},
                                    {kFar, 1}}) {
    signs[bound] = sign;
  }
  for (size_t four = 0; four < kFours; ++four) {
    hn::Vec<D16> values[4];
    for (size_t k = 0; k < 4; ++k) {
      const size_t bound = std::min<size_t>(4 * four + k, kBounds - 1);
      const auto sign = hn::Set(d, signs[bound]);
      values[k] = hn::Set(d, -kInfinity);
      for (size_t i = 0; i < kPackets; i += hn::Lanes(d)) {
        const auto takesPart = hn::Gt(hn::Load(d, beam.bounds[kXUpper] + i), hn::Set(d, -kInfinity));
        const auto lanes = hn::Mul(hn::Load(d, beam.bounds[bound] + i), sign);
        values[k] = hn::IfThenElse(takesPart, hn::Max(values[k], lanes), values[k]);
      }
    }
    storeBest(d, Most(), values, most + 4 * four);
  }
  for (size_t k = 0; k < kBounds; ++k) beam.all[k] = signs[k] * most[k];
}

HWY_INLINE void setWindows(const Hulls &hulls, float margin, Beam &beam) {
  const D16 d;
  const auto half = hn::Set(d, 0.5f), wide = hn::Set(d, margin);
  for (size_t i = 0; i < kPackets; i += hn::Lanes(d)) {
    const auto set = [&](const float(&slope)[2][kPackets], const float(&offset)[2][kPackets], float middleSlope,
                         float meet, size_t first) HWY_ATTR {
      const auto least = hn::Load(d, slope[0] + i), most = hn::Load(d, slope[1] + i), at = hn::Set(d, meet);
      hn::Store(hn::MulSub(hn::Add(least, most), half, hn::Set(d, middleSlope)), d, beam.windows[first] + i);
      hn::Store(hn::MulAdd(hn::Sub(most, least), half, hn::Set(d, kSlopeMargin)), d, beam.windows[first + 1] + i);
      const auto shift = hn::Max(hn::Sub(hn::Load(d, offset[1] + i), at), hn::Sub(at, hn::Load(d, offset[0] + i)));
      hn::Store(hn::Add(shift, wide), d, beam.windows[first + 2] + i);
    };
    set(hulls.xSlope, hulls.x, beam.xSlope, beam.xMeet, kXMiddle);
    set(hulls.ySlope, hulls.y, beam.ySlope, beam.yMeet, kYMiddle);
  }
}

// The hull of the batch without packets that get wider than `widest`: these are not in
// beam.packets.
HWY_INLINE void makeBeam(const Batch &batch, const hal::AccelView &accel, float widest, float fine, bool endless,
                         Beam &beam) {
  const D16 d;
  using V = hn::Vec<D16>;
  const float extent = glm::length(accel.bounds.size());
  const bool before = placeOrigin(batch, extent, beam);
  const float margin = 0x1p-20f * std::max(std::abs(beam.zOffset), batch.size);
  Hulls hulls;
  if (batch.packets < kPackets) hulls = {};
  enclose(batch, beam, endless, before, hulls);
  beam.side = before ? -1.0f : 1.0f;
  beam.rounding = margin;
  beam.packets = 0;
  beam.asksRays = false;
  for (size_t i = 0; i < kPackets; i += hn::Lanes(d)) {
    V bounds[kBounds];
    boundsOf(d, hulls, i, before, margin, bounds);
    const V width = spread(d, batch, beam, bounds, accel.core);
    const auto narrow = hn::Le(width, hn::Set(d, widest));
    const auto there = lanesUpTo(d, i, batch.packets);
    const auto takesPart = hn::And(narrow, there);
    beam.packets |= bitsOf(d, takesPart) << i;
    beam.asksRays |= !hn::AllFalse(d, hn::And(takesPart, hn::Gt(width, hn::Set(d, fine))));
    bounds[kXUpper] = hn::IfThenElse(takesPart, bounds[kXUpper], hn::Set(d, -kInfinity));
    bounds[kFar] = hn::IfThenElse(takesPart, bounds[kFar], hn::Set(d, -kFarthest));
    for (size_t k = 0; k < kBounds; ++k) hn::Store(bounds[k], d, beam.bounds[k] + i);
  }
  unite(before, beam);
  beam.xMeet = (beam.all[kXUpper] + beam.all[kXLower]) * 0.5f;
  beam.yMeet = (beam.all[kYUpper] + beam.all[kYLower]) * 0.5f;
  beam.xSlope = (beam.all[kXUpperSlope] + beam.all[kXLowerSlope]) * 0.5f;
  beam.ySlope = (beam.all[kYUpperSlope] + beam.all[kYLowerSlope]) * 0.5f;
  setWindows(hulls, margin, beam);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
