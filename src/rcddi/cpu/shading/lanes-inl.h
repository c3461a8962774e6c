// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lanes-inl.h: the vectors of shading: a lane is a ray, a hit or a pixel. Products and sums are done in the order of
// the scalar units and never fused, so that both compute the same bits.
#if defined(RAYCORE_SHADING_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_LANES_INL
#undef RAYCORE_SHADING_LANES_INL
#else
#define RAYCORE_SHADING_LANES_INL
#endif

#include "rcddi/cpu/kernels/vectors-inl.h"
#include "rchal/queues.h"

// Instrumented, one function of everything keeps compilers busy for minutes: with sanitizers the steps stay functions.
#undef RC_STEP
#ifdef RAYCORE_FEW_TARGETS
#define RC_STEP HWY_NOINLINE inline
#else
#define RC_STEP HWY_INLINE
#endif

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

using FTag = D16;
using ITag = hn::RebindToSigned<FTag>;
using UTag = hn::RebindToUnsigned<FTag>;
using F = hn::Vec<FTag>;
using I = hn::Vec<ITag>;
using U = hn::Vec<UTag>;
using M = hn::Mask<FTag>;

HWY_INLINE size_t lanes() { return hn::Lanes(FTag()); }
HWY_INLINE F all(float value) { return hn::Set(FTag(), value); }
HWY_INLINE F zero() { return hn::Zero(FTag()); }
HWY_INLINE bool none(M mask) { return hn::AllFalse(FTag(), mask); }
HWY_INLINE F select(M mask, F yes, F no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE F onlyWhere(M mask, F value) { return hn::IfThenElseZero(mask, value); }

// A vector, or a colour, for each lane.
struct V3 {
  F x, y, z;
};

HWY_INLINE V3 all(const Vec3 &v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE V3 operator+(const V3 &a, const V3 &b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 operator-(const V3 &a, const V3 &b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V3 operator*(const V3 &a, const V3 &b) { return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)}; }
HWY_INLINE V3 operator*(F s, const V3 &v) { return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)}; }
HWY_INLINE V3 operator-(const V3 &v) { return {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)}; }
HWY_INLINE V3 select(M mask, const V3 &yes, const V3 &no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_INLINE V3 onlyWhere(M mask, const V3 &v) {
  return {onlyWhere(mask, v.x), onlyWhere(mask, v.y), onlyWhere(mask, v.z)};
}
HWY_INLINE V3 negateWhere(M mask, const V3 &v) { return select(mask, -v, v); }
HWY_INLINE F dot(const V3 &a, const V3 &b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V3 cross(const V3 &a, const V3 &b) {
  const auto minor = [](F p, F q, F r, F s) HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
  return {minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
}
HWY_INLINE F length(const V3 &v) { return hn::Sqrt(dot(v, v)); }
HWY_INLINE F maxComponent(const V3 &v) { return hn::Max(v.x, hn::Max(v.y, v.z)); }
// As in base/vec.h.
HWY_INLINE M isLength(F length) { return hn::And(hn::Gt(length, zero()), hn::Lt(length, all(kInfinity))); }
RC_STEP V3 directionOf(const V3 &v, F length, const V3 &fallback) {
  return select(isLength(length), hn::Div(all(1), length) * v, fallback);
}
RC_STEP V3 directionOf(const V3 &v, const V3 &fallback) { return directionOf(v, length(v), fallback); }
RC_STEP V3 normalizedOr(const V3 &v, const V3 &fallback) {
  const F size = length(v);
  return select(isLength(size), V3{hn::Div(v.x, size), hn::Div(v.y, size), hn::Div(v.z, size)}, fallback);
}

// The items of a column from `first` on. Columns have room for a vector behind their end.
HWY_INLINE F load(const hal::FloatsOfQueue &column, size_t first) { return hn::LoadU(FTag(), column.data() + first); }
HWY_INLINE U load(const hal::NumbersOfQueue &column, size_t first) { return hn::LoadU(UTag(), column.data() + first); }
HWY_INLINE V3 load(const hal::VectorsOfQueue &column, size_t first) {
  return {load(column.x, first), load(column.y, first), load(column.z, first)};
}

constexpr size_t kMostLanes = 16;

#if HWY_TARGET != HWY_SCALAR
// Four floats of lanes i, i + 4, ...: column i of the 4 x 4 blocks that the lanes make.
template <class D, size_t kLanes = hn::MaxLanes(D())>
HWY_INLINE hn::Vec<D> loadEveryFourth(D d, const float *const *places, size_t offset) {
  const hn::FixedTag<float, 4> d4;
  if constexpr (kLanes == 4) {
    return hn::LoadU(d4, places[0] + offset);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, loadEveryFourth(half, places + kLanes / 2, offset), loadEveryFourth(half, places, offset));
  }
}
#endif

// Four floats that lie beside each other, for each lane from its own place. `offset` in floats. Loads and shuffles:
// gathers take several times as long on most machines.
RC_STEP void loadRow(const float *const (&places)[kMostLanes], size_t offset, F *out) {
#if HWY_TARGET == HWY_SCALAR
  for (size_t k = 0; k < 4; ++k) out[k] = all(places[0][offset + k]);
#else
  const FTag d;
  const hn::RepartitionToWide<FTag> wide;
  const F a = loadEveryFourth(d, places, offset), b = loadEveryFourth(d, places + 1, offset);
  const F c = loadEveryFourth(d, places + 2, offset), e = loadEveryFourth(d, places + 3, offset);
  const auto abLow = hn::BitCast(wide, hn::InterleaveLower(d, a, b));
  const auto abHigh = hn::BitCast(wide, hn::InterleaveUpper(d, a, b));
  const auto ceLow = hn::BitCast(wide, hn::InterleaveLower(d, c, e));
  const auto ceHigh = hn::BitCast(wide, hn::InterleaveUpper(d, c, e));
  out[0] = hn::BitCast(d, hn::InterleaveLower(wide, abLow, ceLow));
  out[1] = hn::BitCast(d, hn::InterleaveUpper(wide, abLow, ceLow));
  out[2] = hn::BitCast(d, hn::InterleaveLower(wide, abHigh, ceHigh));
  out[3] = hn::BitCast(d, hn::InterleaveUpper(wide, abHigh, ceHigh));
#endif
}

HWY_INLINE void store(F value, size_t first, hal::FloatsOfQueue &column) {
  hn::StoreU(value, FTag(), column.data() + first);
}
HWY_INLINE void store(U value, size_t first, hal::NumbersOfQueue &column) {
  hn::StoreU(value, UTag(), column.data() + first);
}
HWY_INLINE void store(const V3 &value, size_t first, hal::VectorsOfQueue &column) {
  store(value.x, first, column.x);
  store(value.y, first, column.y);
  store(value.z, first, column.z);
}

// The lanes of a mask together, first.
HWY_INLINE F packed(F value, M mask) { return packed(FTag(), value, mask); }
HWY_INLINE U packed(U value, M mask) { return packed(UTag(), value, hn::RebindMask(UTag(), mask)); }
HWY_INLINE V3 packed(const V3 &value, M mask) {
  return {packed(value.x, mask), packed(value.y, mask), packed(value.z, mask)};
}

// Appends an item for each lane of the mask to a queue that has room for a vector; fill(put) calls put(value, column)
// for each of its columns. Returns how many. Mostly it is all lanes: then nothing need be packed.
template <class Queue, class Fill>
RC_STEP size_t append(M asked, hal::ColumnBlock<Queue> &queue, Fill &&fill) {
  const size_t end = queue.size(), count = hn::CountTrue(FTag(), asked);
  if (count == lanes()) {
    fill([&](const auto &value, auto &column) HWY_ATTR { store(value, end, column); });
  } else {
    fill([&](const auto &value, auto &column) HWY_ATTR { store(packed(value, asked), end, column); });
  }
  queue.extend(count);
  return count;
}

// Adds to the sums of pixels. Mostly the pixels of a vector follow each other; else lane by lane, since several rays
// may belong to one pixel.
RC_STEP void addToPixels(const V3 &colour, M mask, U pixel, const hal::PixelSums &sums) {
  const FTag d;
  const UTag du;
  const V3 counted = onlyWhere(mask, colour);
  const uint32_t first = hn::GetLane(pixel);
  float *const columns[3] = {sums.red, sums.green, sums.blue};
  const F values[3] = {counted.x, counted.y, counted.z};
  const auto follows = hn::Eq(pixel, countFrom(du, first));
  if (none(hn::AndNot(hn::RebindMask(d, follows), mask))) {
    for (size_t k = 0; k < 3; ++k)
      hn::StoreU(hn::Add(hn::LoadU(d, columns[k] + first), values[k]), d, columns[k] + first);
    return;
  }
  alignas(64) uint32_t pixels[kMostLanes];
  alignas(64) float lane[kMostLanes];
  hn::Store(pixel, du, pixels);
  for (size_t k = 0; k < 3; ++k) {
    hn::Store(values[k], d, lane);
    for (uint32_t bits = bitsOf(d, mask); bits;) {
      const size_t i = nextBit(bits);
      columns[k][pixels[i]] += lane[i];
    }
  }
}
}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
