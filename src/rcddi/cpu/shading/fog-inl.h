// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fog-inl.h: units/fog.h for lanes.
// In: Fog, RayLanes.  Out: the fog's light into the sums; the rays are weakened.  Next: shade-inl.h
#if defined(RAYCORE_SHADING_FOG_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_FOG_INL
#undef RAYCORE_SHADING_FOG_INL
#else
#define RAYCORE_SHADING_FOG_INL
#endif

#include "rcddi/cpu/shading/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

RC_STEP F fogTransmission(const hal::Fog &fog, F distance) {
  const F density = hn::Mul(all(fog.density), distance);
  switch (fog.mode) {
    case hal::FogMode::Off:
      break;
    case hal::FogMode::Linear: {
      if (fog.start == fog.end) return onlyWhere(hn::Lt(distance, all(fog.end)), all(1));
      const F left = hn::Div(hn::Sub(all(fog.end), distance), all(fog.end - fog.start));
      return hn::Min(hn::Max(left, zero()), all(1));
    }
    case hal::FogMode::Exp:
      return exp2Of(hn::Mul(all(-hal::kLog2E), density));
    case hal::FogMode::Exp2:
      return exp2Of(hn::Mul(all(-hal::kLog2E), hn::Mul(density, density)));
  }
  return all(1);
}

// units/fog.h: takes the rays to their hits.
RC_STEP void passFog(const Shading &shading, RayLanes &rays, M straight) {
  const hal::Fog &fog = shading.scene.fog;
  const F travelled = load(shading.rays.travelled, rays.first);
  const F afterT = load(shading.rays.afterT, rays.first);
  const F before = hn::Max(hn::Add(travelled, afterT), zero()), behind = hn::Max(hn::Add(travelled, rays.t), zero());
  const M later = shading.out.bounces == 0 ? straight : rays.found;
  const F atStart = select(later, fogTransmission(fog, before), all(1));
  const F share = hn::Min(hn::Div(fogTransmission(fog, behind), atStart), all(1));
  const F left = onlyWhere(hn::Gt(atStart, zero()), share);
  addToPixels((hn::Sub(all(1), left) * rays.weight) * all(fog.color), rays.found, rays.pixel, shading.out.sums);
  rays.weight = left * rays.weight;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
