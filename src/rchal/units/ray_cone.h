// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_cone.h: the footprint of a ray as a cone: how wide it is decides which mip level is read, and curved mirrors and
// lenses widen or narrow it. [spec 3.4]
// Akenine-Moeller et al., "Texture Level of Detail Strategies for Real-Time Ray Tracing", Ray Tracing Gems 20, and
// "Improved Shader and Texture Level of Detail Using Ray Cones", JCGT 10(1), 2021.
// In: HotTriangle, TriangleAttributes, width.  Out: level of detail; growth of the next cone.  Next: units/texture.h
#pragma once

#include "rchal/units/elementary.h"
#include "rchal/units/hit_point.h"

namespace rc::hal {

// A surface that is seen from its edge is looked at as if from so little above.
inline constexpr float kLeastCosine = 1e-3f;

// Level of detail of a texture where a cone of this width meets a triangle.
inline float levelOfDetail(const HotTriangle &triangle, const TriangleAttributes &attributes,
                           const TextureView &texture, float coneWidth, float cosine) {
  const Vec2 du = attributes.uv[1] - attributes.uv[0], dv = attributes.uv[2] - attributes.uv[0];
  const float texelArea =
      std::abs(du.x * dv.y - dv.x * du.y) * static_cast<float>(texture.width) * static_cast<float>(texture.height);
  // Half the logarithm of texels in an area times the area of the footprint.
  const float leastCosine = std::max(cosine, kLeastCosine);
  const float texels = texelArea * (coneWidth * coneWidth), area = triangle.doubleArea * (leastCosine * leastCosine);
  return 0.5f * log2Of(texels / area);
}

// How fast the interpolated normals turn over the triangle, 1 / radius: above 0 where the surface bulges towards the
// side the ray came from. The mean over the edges; a flat triangle has none.
inline float curvature(const HotTriangle &triangle, const TriangleAttributes &attributes, const Vec3 &flatNormal) {
  if (!(triangle.flags & kHasNormals)) return 0;
  const Vec3 vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
  float sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t next = (i + 1) % 3;
    const Vec3 edge = vertices[next] - vertices[i], turn = attributes.normal[next] - attributes.normal[i];
    sum += glm::dot(turn, edge) / glm::dot(edge, edge);
  }
  const bool turned = glm::dot(attributes.normal[0], flatNormal) < 0;
  return (turned ? -sum : sum) / 3;
}

// Growth of a cone after a mirror: the normal turns over its width, the reflected direction twice as much.
inline float reflectedSpread(float spread, float width, float curvature) { return spread + 2 * curvature * width; }

// After a change of medium, eta = index before / index behind, for small angles.
inline float refractedSpread(float spread, float width, float curvature, float eta) {
  return eta * spread + (eta - 1) * curvature * width;
}

}  // namespace rc::hal
