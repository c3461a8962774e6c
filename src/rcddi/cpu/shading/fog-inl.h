// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fog-inl.h: units/fog.h for lanes.
// In: Fog, RayLanes, weight of the surface.  Out: the fog's light into the sums, what it leaves.  Next: shade-inl.h
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

// units/fog.h, and what the fog adds.
RC_STEP V3 throughFog(const Shading &shading, const RayLanes &rays, const V3 &weight, M shaded) {
  const hal::Fog &fog = shading.scene.fog;
  const F travelled = load(shading.rays.travelled, rays.first);
  const F behind = fogTransmission(fog, hn::Max(hn::Add(travelled, rays.t), zero()));
  const F atStart = shading.out.bounces == 0 ? all(1) : fogTransmission(fog, hn::Max(travelled, zero()));
  const F left = onlyWhere(hn::Gt(atStart, zero()), hn::Min(hn::Div(behind, atStart), all(1)));
  addToPixels((hn::Sub(all(1), left) * weight) * all(fog.color), shaded, rays.pixel, shading.out.sums);
  return left * weight;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
