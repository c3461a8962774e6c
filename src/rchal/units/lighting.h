// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lighting.h: what one light gives one point, by Phong's model. [spec 3.3, 4; G 4, 6.2]
// In: LightRow, SurfacePoint, colours of the surface.  Out: LightTerm.  Next: units/shading.h
#pragma once

#include "rchal/units/elementary.h"
#include "rchal/units/hit_point.h"

namespace rc::hal {

// The surface's side of Phong's model: a texel may have replaced ambient and diffuse.
struct SurfaceColours {
  Rgb ambient, diffuse, specular;
  float shininess, leastShine;
};

struct LightTerm {
  Rgb ambient{0};  // not touched by shadow
  Rgb direct{0};   // diffuse and highlight, if nothing is in the way
  Vec3 towards;    // the way to the light; unit, if that is directional
  Vec3 direction;  // unit
  float distance;  // infinite for a directional light
};

// 1 inside the inner cone, 0 outside the outer one, a Hermite step between; times cos^exponent.
inline float spotFactor(const LightRow &light, const Vec3 &direction) {
  if (!light.spot) return 1;
  const float cosine = glm::dot(-direction, light.spotDirection);
  if (cosine < light.cosOuter) return 0;
  float edge = 1;
  if (cosine < light.cosInner) {
    const float s = (cosine - light.cosOuter) / (light.cosInner - light.cosOuter);
    edge = s * s * (3 - 2 * s);
  }
  return edge * powOf(std::max(cosine, 0.0f), light.spotExponent);
}

inline float attenuation(const LightRow &light, float distance) {
  if (light.directional) return 1;
  const float divisor =
      light.fades() ? light.constant + distance * (light.linear + distance * light.quadratic) : light.constant;
  const float factor = divisor > 0 ? 1 / divisor : 1;  // coefficients of (0, 0, 0) mean none
  if (light.rangeEnd <= light.rangeStart) return factor;
  return factor * std::clamp((light.rangeEnd - distance) / (light.rangeEnd - light.rangeStart), 0.0f, 1.0f);
}

// view: unit, towards where the ray came from.
inline LightTerm lightAt(const LightRow &light, const SurfacePoint &point, const Vec3 &view,
                         const SurfaceColours &surface) {
  LightTerm term;
  term.towards = light.directional ? light.position : light.position - point.position;
  term.distance = light.directional ? kInfinity : glm::length(term.towards);
  term.direction = light.directional ? term.towards : directionOf(term.towards, term.distance, point.normal);
  const float strength = attenuation(light, term.distance) * spotFactor(light, term.direction);
  term.ambient = strength * surface.ambient * light.ambient;
  const float cosine = glm::dot(point.normal, term.direction);
  if (cosine <= 0) return term;
  term.direct = surface.diffuse * light.diffuse;
  const Rgb highlight = surface.specular * light.specular;
  if (maxComponent(highlight) > 0) {
    // The direction mirrored by the normal, times the view.
    const float towardsView = 2 * cosine * glm::dot(point.normal, view) - glm::dot(term.direction, view);
    if (towardsView > surface.leastShine) {
      term.direct += highlight * powOf(std::max(towardsView, 0.0f), surface.shininess);
    }
  }
  term.direct *= strength * cosine;
  return term;
}

}  // namespace rc::hal
