// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// hulls-inl.h: the intervals of slopes, offsets and depths that the rays of each packet lie in.
// In: Batch, where depth 0 of its beam is.  Out: Hulls.  Next: beam_setup-inl.h
#if defined(RAYCORE_KERNELS_HULLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_HULLS_INL
#undef RAYCORE_KERNELS_HULLS_INL
#else
#define RAYCORE_KERNELS_HULLS_INL
#endif

#include "rcddi/cpu/kernels/beam-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// What the rays of each packet lie between: least and most slopes, and offsets at depth 0; the first depth where one
// starts, the last where one ends.
struct alignas(64) Hulls {
  float xSlope[2][kPackets], ySlope[2][kPackets], x[2][kPackets], y[2][kPackets], start[kPackets], end[kPackets];
};

// The best value among the rays of each packet. value(i): of the rays from i on.
template <class Best, class F>
HWY_INLINE void bestOfPackets(const Batch &batch, F value, Best best, float (&out)[kPackets]) {
  const D16 d;
  for (size_t packet = 0; packet < batch.packets; packet += 4) {
    hn::Vec<D16> four[4];
    for (size_t k = 0; k < 4; ++k) {
      const size_t begin = std::min(packet + k, batch.packets - 1) * kPacketRays;
      four[k] = value(begin);
      for (size_t i = hn::Lanes(d); i < kPacketRays; i += hn::Lanes(d)) four[k] = best(four[k], value(begin + i));
    }
    storeBest(d, best, four, out + packet);
  }
}

template <class F>
HWY_INLINE void enclose(const Batch &batch, F value, float (&out)[2][kPackets]) {
  bestOfPackets(batch, value, Least(), out[0]);
  bestOfPackets(batch, value, Most(), out[1]);
}

inline void fill(float (&out)[kPackets], float value) { std::fill(std::begin(out), std::end(out), value); }

// Encloses the rays of all packets at once. Returns whether they are no farther apart than `close`: else `out` is as it
// was.
template <class F>
HWY_INLINE bool encloseTogether(const Batch &batch, F value, float close, float (&out)[2][kPackets]) {
  const D16 d;
  auto least = value(0), most = least;
  for (size_t i = hn::Lanes(d); i < batch.packets * kPacketRays; i += hn::Lanes(d)) {
    const auto v = value(i);
    least = hn::Min(least, v);
    most = hn::Max(most, v);
  }
  const float first = hn::GetLane(hn::MinOfLanes(d, least)), last = hn::GetLane(hn::MaxOfLanes(d, most));
  if (!(last - first <= close)) return false;
  fill(out[0], first);
  fill(out[1], last);
  return true;
}

// Where rays meet, and how far they go by each other there, is the same for all packets.
HWY_INLINE void encloseOffsets(const Batch &batch, const Beam &beam, Hulls &out) {
  const D16 d;
  const auto sign = hn::Set(d, batch.zSign), offset = hn::Set(d, beam.zOffset);
  const auto at = [&](const float *slopes, int axis, size_t i) HWY_ATTR {
    const auto depth = hn::MulAdd(hn::LoadU(d, batch.origin[batch.kz] + i), sign, offset);
    return hn::NegMulAdd(hn::Mul(hn::Load(d, slopes + i), sign), depth, hn::LoadU(d, batch.origin[axis] + i));
  };
  const auto x = [&](size_t i) HWY_ATTR { return at(batch.sx, batch.kx, i); };
  const auto y = [&](size_t i) HWY_ATTR { return at(batch.sy, batch.ky, i); };
  const float close = 0x1p-14f * std::max(std::abs(beam.zOffset), batch.size);
  if (!encloseTogether(batch, x, close, out.x)) enclose(batch, x, out.x);
  if (!encloseTogether(batch, y, close, out.y)) enclose(batch, y, out.y);
}

// endless: no ray has an end yet. before: all end where they meet, or before.
HWY_INLINE void enclose(const Batch &batch, const Beam &beam, bool endless, bool before, Hulls &out) {
  const D16 d;
  const auto sign = hn::Set(d, batch.zSign), offset = hn::Set(d, beam.zOffset);
  const auto slope = [&](const float *slopes)
                         HWY_ATTR { return [=](size_t i) HWY_ATTR { return hn::Mul(hn::Load(d, slopes + i), sign); }; };
  enclose(batch, slope(batch.sx), out.xSlope);
  enclose(batch, slope(batch.sy), out.ySlope);
  if (batch.common) {
    for (float(&side)[kPackets] : out.x) fill(side, batch.origin[batch.kx][0]);
    for (float(&side)[kPackets] : out.y) fill(side, batch.origin[batch.ky][0]);
    fill(out.start, 0);
  } else {
    const float *oz = batch.origin[batch.kz];
    encloseOffsets(batch, beam, out);
    bestOfPackets(
        batch, [&](size_t i) HWY_ATTR { return hn::MulAdd(hn::LoadU(d, oz + i), sign, offset); }, Least(), out.start);
  }
  if (endless) return fill(out.end, kFarthest);
  if (before) return fill(out.end, batch.end + hal::kSlack * (batch.end - batch.start) + beam.zOffset);
  bestOfPackets(
      batch, [&](size_t i) HWY_ATTR { return endsOf(batch, beam, i); }, Most(), out.end);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
