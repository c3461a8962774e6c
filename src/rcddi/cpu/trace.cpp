// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// trace.cpp: the kernels once for each instruction set, and the choice among them when the program runs.
#include "rcddi/cpu/trace.h"

#include "base/simd_targets.h"
#include "rchal/units/traversal.h"

// Highway compiles this file again for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rcddi/cpu/trace.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "rcddi/cpu/kernels/group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

void closestHitsOf(const hal::SceneView &scene, const RayStream &rays, hal::HitQueue &hits) {
  hits.resize(rays.count);
  traceStream<false>(scene, rays, nullptr, &hits, nullptr);
}

void findBlockedOf(const hal::SceneView &scene, const RayStream &rays, uint8_t *blocked, FilterHits *filters) {
  traceStream<true>(scene, rays, filters, nullptr, blocked);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rc::ddi::cpu {

HWY_EXPORT(closestHitsOf);
HWY_EXPORT(findBlockedOf);

void closestHits(const hal::SceneView &scene, const RayStream &rays, hal::HitQueue &hits) {
  HWY_DYNAMIC_DISPATCH(closestHitsOf)(scene, rays, hits);
}

void findBlocked(const hal::SceneView &scene, const RayStream &rays, uint8_t *blocked, FilterHits *filters) {
  HWY_DYNAMIC_DISPATCH(findBlockedOf)(scene, rays, blocked, filters);
}

}  // namespace rc::ddi::cpu
#endif
