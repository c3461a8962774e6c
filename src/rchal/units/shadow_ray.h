// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shadow_ray.h: the rays that ask whether something is between a point of a surface and a light.
// In: LightRow, SurfacePoint, LightTerm.  Out: Ray, Reach.  Next: units/shading.h asks, units/shadow.h answers.
//
// They start at the light where that is not too far off: then all rays of a light have one origin, and kernels need not
// look at each one's. Only where they end differs from point to point. Rays of a far light start at the surface: seen
// from so far away, float could not tell the surface from what is close to it. So do those of a directional light.
#pragma once

#include "base/bounds.h"
#include "rchal/units/lighting.h"
#include "rchal/units/traversal.h"

namespace rc::hal {

// A light that lies on a surface is not hidden by it: so much of the way is left out there.
inline constexpr float kAtLight = 1e-5f;

// Lights farther off than so many sizes of what they shine on are far.
inline constexpr float kFarLight = 16;

// What they shine on lies within `scene`.
inline bool sendsShadowRays(const LightRow &light, const Bounds &scene) {
  if (light.directional) return false;
  const Vec3 off = glm::max(scene.lower - light.position, light.position - scene.upper);
  return maxComponent(off) <= kFarLight * maxComponent(scene.size());  // not if there is nothing
}

inline Reach reachOf(const LightRow &light) {
  if (light.directional) return {.begin = 0, .end = kInfinity, .fromLight = false};
  if (light.sendsShadowRays) return {.begin = kAtLight, .end = 1, .fromLight = true};
  return {.begin = 0, .end = 1 - kAtLight, .fromLight = false};
}

// How far off the surface a ray from the light ends: hits that far from it are rounded by its distance, too.
inline float endOffset(const SurfacePoint &point, float distance) {
  return std::max(point.safeOffset, kPositionError * distance);
}

// term: what the light gives the point.
inline Ray shadowRay(const LightRow &light, const SurfacePoint &point, const LightTerm &term) {
  if (!light.sendsShadowRays) return {point.start(term.direction), term.towards};
  return {light.position, point.offset(term.direction, endOffset(point, term.distance)) - term.towards};
}

}  // namespace rc::hal
