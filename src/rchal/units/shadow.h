// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shadow.h: how much of a light gets through to a point. [spec 4; reference 4.2, 4.3]
// In: SceneView, ShadowItem's ray, Reach of its light.  Out: share per channel.  Next: rchal/tile_tracer.h adds the
// colour.
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
  if ((triangle.flags & kFiltersShadow) == kTransmittanceShadow) return material.shadowTint;
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

// What is left of the light on its way through triangles that let some through, which are told in the order of the ray.
class FilteredLight {
 public:
  // direction: towards the light.
  FilteredLight(const SceneView &scene, const Vec3 &direction) : mScene(scene), mDirection(direction) {}

  // Returns whether anything is left.
  bool pass(const Hit &hit) {
    const auto [geometry, index] = placeOf(mScene, hit.primitive);
    const Rgb passing = shadowFilter(mScene, geometry, index, hit, mDirection);
    if (passing == Rgb(1)) return true;
    if (!isSameSurface(mScene, mLast, hit)) mShare *= passing;
    if (maxComponent(mShare) <= 0) mShare = Rgb(0);
    mLast = {hit.t, hit.primitive};
    return mShare != Rgb(0);
  }
  const Rgb &share() const { return mShare; }

 private:
  const SceneView &mScene;
  const Vec3 mDirection;
  Rgb mShare{1};
  HitOrder mLast;  // that took some
};

inline Rgb visibility(const SceneView &scene, const Ray &ray, const Reach &reach) {
  if (isBlocked(scene, ray, reach)) return Rgb(0);
  FilteredLight light(scene, reach.towardsLight(ray.direction));
  if (scene.filtersShadow()) forEachHit(scene, ray, reach, [&](const Hit &hit) { return light.pass(hit); });
  return light.share();
}

}  // namespace rc::hal
