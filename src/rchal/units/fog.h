// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fog.h: surfaces fade to the colour of the fog by the way their light has to the eye, along mirrors and through
// glass too. What meets nothing keeps the clear colour. [OpenGL ES 1.1, 3.8]
// In: Fog, RayItem, distance of its hit.  Out: the fog's light; the item is weakened.  Next: units/shading.h
#pragma once

#include "rchal/queues.h"
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

// Takes the item to its hit: what the fog adds on this piece of the way; the rest of the item's weight is for the
// surface. Pieces multiply to the transmission of the whole way.
inline Rgb passFog(const Fog &fog, RayItem &item, float t, bool fromEye) {
  if (fog.mode == FogMode::Off) return Rgb(0);
  // Parallel rays may start behind the eye.
  const float before = std::max(item.travelled + item.after.t, 0.0f), behind = std::max(item.travelled + t, 0.0f);
  // The first piece counts as the whole way: the fog may begin behind the eye, or end before it begins.
  const bool first = fromEye && item.after.primitive == kNoPrimitive;
  const float atStart = first ? 1.0f : fogTransmission(fog, before);
  const float left = atStart > 0 ? std::min(fogTransmission(fog, behind) / atStart, 1.0f) : 0.0f;
  const Rgb added = item.weight * (1 - left) * fog.color;
  item.weight *= left;
  return added;
}

}  // namespace rc::hal
