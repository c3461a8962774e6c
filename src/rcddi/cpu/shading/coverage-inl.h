// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// coverage-inl.h: units/coverage.h for lanes: how much of a surface is there.
// In: flags, SurfaceLanes, opacity.  Out: 0 ... 1 for each lane.  Next: shade-inl.h
#if defined(RAYCORE_SHADING_COVERAGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_COVERAGE_INL
#undef RAYCORE_SHADING_COVERAGE_INL
#else
#define RAYCORE_SHADING_COVERAGE_INL
#endif

#include "rcddi/cpu/shading/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

RC_STEP F passesAlphaTest(uint32_t flags, F opacity) {
  const uint32_t code = (flags & hal::kAlphaTestMask) >> hal::kAlphaTestShift;
  if (code == 0) return all(1);
  if (code == hal::kAlphaNever) return zero();
  const F level = hn::Floor(hn::Add(hn::Mul(opacity, all(255)), all(0.5f)));
  const F reference = all(static_cast<float>(flags >> hal::kAlphaReferenceShift & 255));
  F passes = zero();
  if (code & hal::kAlphaLess) passes = select(hn::Lt(level, reference), all(1), passes);
  if (code & hal::kAlphaEqual) passes = select(hn::Eq(level, reference), all(1), passes);
  if (code & hal::kAlphaGreater) passes = select(hn::Gt(level, reference), all(1), passes);
  return passes;
}

// units/coverage.h. opacity: of the texels.
RC_STEP F coverage(uint32_t flags, const SurfaceLanes &surface, F opacity) {
  F there = hn::Mul(opacity, passesAlphaTest(flags, opacity));
  if (flags & hal::kCullFront) there = select(surface.front, zero(), there);
  if (flags & hal::kCullBack) there = onlyWhere(surface.front, there);
  return there;
}

// Lanes whose surface was seen already, as another of its triangles that meet here.
HWY_NOINLINE inline M seenBefore(const Shading &shading, size_t first, uint32_t lanesAsked) {
  alignas(64) float seen[kMostLanes] = {};
  while (lanesAsked) {
    const size_t lane = nextBit(lanesAsked), at = first + lane;
    if (!shading.rays.afterSeen[at]) continue;
    if (hal::isSameSurface(shading.scene, shading.rays.after(at), shading.hits[at])) seen[lane] = 1;
  }
  return hn::Gt(hn::Load(FTag(), seen), zero());
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
