// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// sums-inl.h: what lights add to pixels whose shadow rays were not blocked.
#if defined(RAYCORE_SHADING_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_SUMS_INL
#undef RAYCORE_SHADING_SUMS_INL
#else
#define RAYCORE_SHADING_SUMS_INL
#endif

#include "rcddi/cpu/shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

HWY_INLINE void addUnblocked(const hal::ShadowQueue &shadows, const uint8_t *blocked, const hal::PixelSums &sums) {
  const FTag d;
  const hn::Rebind<uint8_t, FTag> bytes;
  for (size_t i = 0; i < shadows.size(); i += lanes()) {
    const I dark = hn::PromoteTo(ITag(), hn::LoadU(bytes, blocked + i));
    const M inside = lanesUpTo(d, i, shadows.size());
    const M lit = hn::And(inside, hn::RebindMask(d, hn::Eq(dark, hn::Zero(ITag()))));
    if (none(lit)) continue;
    addToPixels(load(shadows.colour, i), lit, load(shadows.pixel, i), sums);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
