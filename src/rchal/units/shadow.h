// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shadow.h: how much of a light gets through to a point. [spec 4; reference 4.2, 4.3]
// In: SceneView, ShadowItem's ray and distance.  Out: share per channel.  Next: rchal/frame.h adds the colour.
#pragma once

#include "rchal/units/coverage.h"
#include "rchal/units/hit_point.h"
#include "rchal/units/texture.h"
#include "rchal/units/traversal.h"

namespace rc::hal {

// What one triangle lets through where the shadow ray crosses it.
inline Rgb shadowFilter(const SceneView &scene, const GeometryView &geometry, uint32_t index, const Hit &hit,
                        const Vec3 &direction) {
  const HotTriangle &triangle = geometry.triangles[index];
  const MaterialRow &material = materialOf(scene, geometry, triangle);
  const SurfacePoint point = surfacePoint(geometry, index, hit, direction);
  float opacity = 1;
  if (triangle.flags & (kAlphaShadow | kAlphaTestMask) && material.texture != kNoTexture) {
    const TextureView &texture = scene.textures[size_t(material.texture)];
    opacity = opacityOf(material, texture, sampleTexture(texture, point.uv, material.textureWrap, 0).w);
  }
  const float there = coverage(triangle.flags, point.front, opacity);
  if (there <= 0) return Rgb(1);
  const Rgb share = triangle.flags & kTransmittanceShadow ? material.shadowTint : Rgb(0);
  return triangle.flags & kAlphaShadow ? glm::mix(Rgb(1), share, there) : share;
}

// How far a shadow ray looks: a light that lies on a surface is not hidden by it.
inline float shadowEnd(float distance) { return distance * (1 - 1e-5f); }

// What the triangles let through that let some light through, where no other is in the way.
inline Rgb throughFilters(const SceneView &scene, const Ray &ray, float end) {
  Rgb share{1};
  if (!scene.filtersShadow()) return share;
  HitOrder last;
  bool filtered = false;  // by the last one
  for (;;) {
    const Hit hit = nextHit(scene, ray, last, end);
    if (!hit.found()) return share;
    const auto [geometry, index] = placeOf(scene, hit.primitive);
    const Rgb passing = shadowFilter(scene, geometry, index, hit, ray.direction);
    if (!filtered || !isSameSurface(scene, last, hit)) share *= passing;
    if (maxComponent(share) <= 0) return Rgb(0);
    last = {hit.t, hit.primitive};
    filtered = passing != Rgb(1);
  }
}

inline Rgb visibility(const SceneView &scene, const Ray &ray, float distance) {
  const float end = shadowEnd(distance);
  return isBlocked(scene, ray, end, Blocking::Opaque) ? Rgb(0) : throughFilters(scene, ray, end);
}

}  // namespace rc::hal
