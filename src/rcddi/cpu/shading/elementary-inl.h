// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// elementary-inl.h: units/elementary.h for lanes: the same operations in the same order.
#if defined(RAYCORE_SHADING_ELEMENTARY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_ELEMENTARY_INL
#undef RAYCORE_SHADING_ELEMENTARY_INL
#else
#define RAYCORE_SHADING_ELEMENTARY_INL
#endif

#include "rcddi/cpu/shading/lanes-inl.h"
#include "rchal/units/elementary.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

RC_STEP F log2Of(F x) {
  using namespace hal::elementary;
  const ITag di;
  const I half = hn::Set(di, int32_t{kHalfSquare});
  const I offset = hn::Sub(hn::BitCast(di, x), half);
  const F exponent = hn::ConvertTo(FTag(), hn::ShiftRight<23>(offset));
  const F mantissa = hn::BitCast(FTag(), hn::Add(hn::And(offset, hn::Set(di, 0x7fffff)), half));
  const F s = hn::Div(hn::Sub(mantissa, all(1)), hn::Add(mantissa, all(1)));
  const F s2 = hn::Mul(s, s), s4 = hn::Mul(s2, s2);
  const F low = hn::Add(all(kLog2[0]), hn::Mul(s2, all(kLog2[1]))),
          high = hn::Add(all(kLog2[2]), hn::Mul(s2, all(kLog2[3])));
  const F series = hn::Add(low, hn::Mul(s4, hn::Add(high, hn::Mul(s4, all(kLog2[4])))));
  return select(hn::Ge(x, all(kSmallest)), hn::Add(exponent, hn::Mul(s, series)), all(-kInfinity));
}

RC_STEP F exp2Of(F x) {
  using namespace hal::elementary;
  const ITag di;
  const M counts = hn::Ge(x, all(-126));
  const F clamped = select(counts, hn::Min(x, all(126)), zero());
  const F whole = hn::Floor(hn::Add(clamped, all(0.5f))), f = hn::Sub(clamped, whole);
  const F f2 = hn::Mul(f, f), f4 = hn::Mul(f2, f2);
  const auto pair = [&](int k) HWY_ATTR { return hn::Add(all(kExp2[k]), hn::Mul(f, all(kExp2[k + 1]))); };
  const F low = hn::Add(pair(0), hn::Mul(f2, pair(2))), high = hn::Add(pair(4), hn::Mul(f2, all(kExp2[6])));
  const F series = hn::Add(low, hn::Mul(f4, high));
  const I power = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 127)));
  return onlyWhere(counts, hn::Mul(series, hn::BitCast(FTag(), power)));
}

RC_STEP F powOf(F base, F exponent) {
  return select(hn::Gt(exponent, zero()), exp2Of(hn::Mul(exponent, log2Of(base))), all(1));
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
