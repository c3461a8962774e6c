// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vectors-inl.h: the few names that all kernels share.
#if defined(RAYCORE_KERNELS_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_VECTORS_INL
#undef RAYCORE_KERNELS_VECTORS_INL
#else
#define RAYCORE_KERNELS_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstring>

#include "rcddi/cpu/packed_lanes.h"
#include "rchal/units/traversal.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Lanes of what is looked at together; narrower instruction sets take several steps.
using D4 = hn::CappedTag<float, 4>;    // the triangles of a block
using D8 = hn::CappedTag<float, 8>;    // the children of a node
using D16 = hn::CappedTag<float, 16>;  // the rays of a packet, or packets of a batch

// Instead of infinity, where infinity means that a lane takes no part.
constexpr float kFarthest = 3e38f;

// Bit i: lane i.
template <class D>
HWY_INLINE uint32_t bitsOf(D d, hn::Mask<D> mask) {
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  uint32_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

// The lanes of the mask first, in their order. As hn::Compress, which without AVX-512 copies its table onto the stack
// for each vector (Highway 1.0.3 compiled by GCC).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V packed(D d, V v, hn::Mask<D> mask) {
#if HWY_TARGET == HWY_SCALAR
  (void)d, (void)mask;
  return v;
#elif HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
  (void)d;
  return hn::Compress(v, mask);
#else
  const auto places = hn::LoadU(hn::RebindToUnsigned<D>(), kPackedLanes[bitsOf(d, mask)].data());
  return hn::TableLookupLanes(v, hn::IndicesFromVec(d, places));
#endif
}

// Stores the lanes of the mask; `to` is aligned. As hn::BlendedStore, which with AVX2 is a masked store: tens of
// microinstructions on AMD's processors up to Zen 3, and gains little on Intel's.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void storeWhere(D d, hn::Mask<D> mask, V v, hn::TFromD<D> *to) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
  hn::BlendedStore(v, mask, d, to);
#else
  hn::Store(hn::IfThenElse(mask, v, hn::Load(d, to)), d, to);
#endif
}

// first, first + 1, ...: what hn::Iota does, which writes its lanes one by one and reads them as one vector: processors
// wait for that (Highway 1.0.3). D: integers of 32 bits.
template <class D>
HWY_INLINE hn::Vec<D> countFrom(D d, size_t first) {
  const hn::RebindToUnsigned<D> du;
  const auto numbers = hn::Load(du, kLaneNumbers.numbers);
  return hn::BitCast(d, hn::Add(numbers, hn::Set(du, static_cast<uint32_t>(first))));
}

// The lanes from `first` on that lie before `count`.
template <class D>
HWY_INLINE hn::Mask<D> lanesUpTo(D d, size_t first, size_t count) {
  const hn::RebindToSigned<D> di;
  return hn::RebindMask(d, hn::Lt(countFrom(di, first), hn::Set(di, static_cast<int32_t>(count))));
}

// 1 / direction, finite also where that is 0, as in hal::TraversalRay.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverseOf(D d, V direction) {
  const V small = hn::Set(d, 1e-20f);
  const auto enough = hn::Ge(hn::Abs(direction), small);
  return hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(enough, direction, hn::CopySign(small, direction)));
}

// Takes the lowest bit off.
HWY_INLINE uint32_t nextBit(uint32_t &bits) {
  const auto bit = static_cast<uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
  bits &= bits - 1;
  return bit;
}

// Visits the bits that are set, the lowest first, kAtOnce at a time, the last one again where there are fewer: a loop
// that mostly runs once is foretold better. Visiting a bit again must change nothing.
template <size_t kAtOnce, class Visit>
HWY_INLINE void visitBits(uint32_t bits, Visit &&visit) {
  while (bits) {
    uint32_t bit = 0;
    for (size_t i = 0; i < kAtOnce; ++i) {
      bit = bits ? static_cast<uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)) : bit;
      bits &= bits - 1;
      visit(bit);
    }
  }
}

#if HWY_TARGET == HWY_SCALAR  // vectors of one lane know no other
// The best lane of each of four vectors. best: Min or Max.
template <class D, class F, class V = hn::Vec<D>>
HWY_INLINE void storeBest(D, F, const V (&v)[4], float *out) {
  for (size_t k = 0; k < 4; ++k) out[k] = hn::GetLane(v[k]);
}
#else
// The best of blocks of four lanes.
template <class D, class F>
HWY_INLINE void storeBestBlock(D d, F best, hn::Vec<D> v, float *out) {
  if constexpr (hn::MaxLanes(d) > 4) {
    const hn::Half<D> half;
    storeBestBlock(half, best, best(hn::LowerHalf(half, v), hn::UpperHalf(half, v)), out);
  } else {
    hn::StoreU(v, d, out);
  }
}

// The best lane of each of four vectors. best: Min or Max.
template <class D, class F, class V = hn::Vec<D>>
HWY_INLINE void storeBest(D d, F best, const V (&v)[4], float *out) {
  const hn::Repartition<uint64_t, D> pairs;
  const auto pair = [&](V a, V b) HWY_ATTR {
    return hn::BitCast(pairs, best(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b)));
  };
  const auto first = pair(v[0], v[1]), second = pair(v[2], v[3]);
  const V lower = hn::BitCast(d, hn::InterleaveLower(pairs, first, second));
  storeBestBlock(d, best, best(lower, hn::BitCast(d, hn::InterleaveUpper(pairs, first, second))), out);
}
#endif

struct Least {
  template <class V>
  HWY_INLINE V operator()(V a, V b) const {
    return hn::Min(a, b);
  }
};
struct Most {
  template <class V>
  HWY_INLINE V operator()(V a, V b) const {
    return hn::Max(a, b);
  }
};

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
