// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fog.h: surfaces fade to the colour of the fog by the way their light has to the eye, along mirrors and through
// glass too. What meets nothing keeps the clear colour. [OpenGL ES 1.1, 3.8]
// In: Fog, the way behind a ray and before it.  Out: share of the surface's light that is left.  Next: units/shading.h
#pragma once

#include "rchal/scene_view.h"
#include "rchal/units/elementary.h"

namespace rc::hal {

inline constexpr float kLog2E = 1.44269504f;

// Share of the light that is left after a distance.
inline float fogTransmission(const Fog &fog, float distance) {
  switch (fog.mode) {
    case FogMode::Off:
      return 1;
    case FogMode::Linear:
      if (fog.start == fog.end) return distance < fog.end ? 1.0f : 0.0f;
      return std::clamp((fog.end - distance) / (fog.end - fog.start), 0.0f, 1.0f);
    case FogMode::Exp:
      return exp2Of(-kLog2E * (fog.density * distance));
    case FogMode::Exp2:
      return exp2Of(-kLog2E * ((fog.density * distance) * (fog.density * distance)));
  }
  return 1;
}

// What a leg of the way leaves, from the eye or the last mirror to a hit; the rest is the fog's own light. Legs
// multiply to the transmission of the whole way. What lies behind a layer that is there in part has its own fog, from
// the start of the leg: before the background there is none. travelled: up to the start of the leg; parallel rays may
// start behind the eye.
inline float fogLeft(const Fog &fog, float travelled, float t, bool fromEye) {
  // The first leg counts as the whole way: the fog may begin behind the eye, or end before it begins.
  const float atStart = fromEye ? 1.0f : fogTransmission(fog, std::max(travelled, 0.0f));
  return atStart > 0 ? std::min(fogTransmission(fog, std::max(travelled + t, 0.0f)) / atStart, 1.0f) : 0.0f;
}

}  // namespace rc::hal
