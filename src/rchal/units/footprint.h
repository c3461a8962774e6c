// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// footprint.h: what of a texture a ray sees: round, or stretched where its cone meets a surface at a slant, or where
// the texture itself is. A stretched one is read by several samples side by side, from a finer mip level.
// [spec 3.4; RC_RCX_anisotropy, after EXT_texture_filter_anisotropic]
// In: HotTriangle, TriangleAttributes, width of the cone.  Out: Footprint, a texel.  Next: units/shading.h
#pragma once

#include "rchal/units/ray_cone.h"
#include "rchal/units/texture.h"

namespace rc::hal {

struct Footprint {
  float lod = 0;
  int probes = 1;
  Vec2 axis{0};  // the way over which the probes are spread, in texture coordinates
};

// width: of the cone where it meets the triangle. normal: of its plane, towards where the ray came from.
inline Footprint stretchedFootprint(const HotTriangle &triangle, const TriangleAttributes &attributes,
                                    const TextureView &texture, const Vec3 &normal, const Vec3 &direction,
                                    float width) {
  const Vec3 e1 = triangle.v1 - triangle.v0, e2 = triangle.v2 - triangle.v0;
  const Vec2 du = attributes.uv[1] - attributes.uv[0], dv = attributes.uv[2] - attributes.uv[0];
  // A way on the plane, in texture coordinates.
  const auto onTexture = [&](const Vec3 &way) {
    const float u = glm::dot(glm::cross(way, e2), normal) / triangle.doubleArea;
    const float v = glm::dot(glm::cross(e1, way), normal) / triangle.doubleArea;
    return u * du + v * dv;
  };
  const auto lengthOf = [&](const Vec2 &way) {
    const float x = way.x * float(texture.width), y = way.y * float(texture.height);
    return std::sqrt(x * x + y * y);
  };
  const float facing = glm::dot(normal, direction);
  const Vec3 along = normalizedOr(direction - facing * normal, e1 / glm::length(e1));
  const Vec2 a = onTexture((width / std::max(std::abs(facing), kLeastCosine)) * along);
  const Vec2 b = onTexture(width * glm::cross(normal, along));
  const float lengthA = lengthOf(a), lengthB = lengthOf(b);
  const bool aIsLonger = lengthA > lengthB;
  const float longer = aIsLonger ? lengthA : lengthB, shorter = aIsLonger ? lengthB : lengthA;
  // As many as it is longer than wide; no more than it has texels.
  const float ratio = longer / std::max(shorter, 1.0f);
  const float probes = ratio > 1 ? std::min(std::ceil(ratio), float(texture.anisotropy)) : 1.0f;
  return {log2Of(longer / probes), int(probes), aIsLonger ? a : b};
}

inline Vec4 sampleFootprint(const TextureView &texture, Vec2 uv, Wraps wraps, const Footprint &footprint) {
  if (footprint.probes == 1) return sampleTexture(texture, uv, wraps, footprint.lod);
  const float share = 1.0f / static_cast<float>(footprint.probes);
  Vec4 sum(0);
  for (int i = 0; i < footprint.probes; ++i) {
    const float place = (static_cast<float>(i) + 0.5f) * share - 0.5f;
    sum += sampleTexture(texture, uv + place * footprint.axis, wraps, footprint.lod);
  }
  return sum * share;
}

}  // namespace rc::hal
