// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shadow.h: how much of a light gets through to a point. [spec 4; reference 4.2, 4.3]
// In: SceneView, ShadowItem's ray and distance.  Out: share per channel.  Next: rchal/frame.h adds the colour.
#pragma once

#include "rchal/units/hit_point.h"
#include "rchal/units/texture.h"
#include "rchal/units/traversal.h"

namespace rc::hal {

// What one triangle lets through where the shadow ray crosses it.
inline Rgb shadowFilter(const SceneView &scene, const GeometryView &geometry, uint32_t index, const Hit &hit,
                        const Vec3 &direction) {
  const HotTriangle &triangle = geometry.triangles[index];
  const MaterialRow &material = materialOf(scene, geometry, triangle);
  Rgb share{0};
  if (triangle.flags & kTransmittanceShadow) share = material.shadowTint;
  if (triangle.flags & kAlphaShadow && material.texture != kNoTexture) {
    const TextureView &texture = scene.textures[size_t(material.texture)];
    const SurfacePoint point = surfacePoint(geometry, index, hit, direction);
    const float alpha = sampleTexture(texture, point.uv, material.wrapS, material.wrapT, 0).w;
    share = glm::mix(Rgb(1), share, opacityOf(texture, alpha));
  }
  return share;
}

// Hits closer together than this share of the distance are one.
inline constexpr float kSameSurface = 0x1p-21f;

// How far a shadow ray looks: a light that lies on a surface is not hidden by it.
inline float shadowEnd(float distance) { return distance * (1 - 1e-5f); }

// What the triangles let through that let some light through, where no other is in the way.
inline Rgb throughFilters(const SceneView &scene, const Ray &ray, float end) {
  Rgb share{1};
  if (!scene.filtersShadow()) return share;
  HitOrder last;
  uint32_t lastMaterial = kNoPrimitive;
  for (;;) {
    const Hit hit = nextHit(scene, ray, last, end);
    if (!hit.found()) return share;
    const auto [geometry, index] = placeOf(scene, hit.primitive);
    // Through the common edge of two triangles of one surface: that surface counts once.
    const uint32_t material = geometry.triangles[index].material;
    const bool sameSurface = material == lastMaterial && hit.t - last.t <= hit.t * kSameSurface;
    if (!sameSurface) share *= shadowFilter(scene, geometry, index, hit, ray.direction);
    if (maxComponent(share) <= 0) return Rgb(0);
    last = {hit.t, hit.primitive};
    lastMaterial = material;
  }
}

inline Rgb visibility(const SceneView &scene, const Ray &ray, float distance) {
  const float end = shadowEnd(distance);
  return blockedByOpaque(scene, ray, end) ? Rgb(0) : throughFilters(scene, ray, end);
}

}  // namespace rc::hal
