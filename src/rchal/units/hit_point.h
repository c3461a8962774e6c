// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// hit_point.h: from a hit to the point on the surface: the hit-point calculation unit. [G 1.2]
// In: GeometryView, Hit, Ray.  Out: SurfacePoint.  Next: units/shading.h
#pragma once

#include "rchal/queues.h"
#include "rchal/units/coverage.h"

namespace rc::hal {

struct SurfacePoint {
  Vec3 position;
  Vec3 flatNormal;  // unit, on the side the ray came from
  Vec3 normal;      // unit, interpolated where there are normals, turned with flatNormal
  Vec2 uv{0};
  Rgb color{1};      // of the vertices, interpolated
  float safeOffset;  // as HotTriangle's
  bool front;        // the ray met the front

  // By so much off the surface, to the side that the direction leads to.
  Vec3 offset(const Vec3 &direction, float distance) const {
    return flatNormal * (glm::dot(direction, flatNormal) < 0 ? -distance : distance);
  }
  // Where a ray in the given direction may start.
  Vec3 start(const Vec3 &direction) const { return position + offset(direction, safeOffset); }
};

inline SurfacePoint surfacePoint(const GeometryView &geometry, uint32_t index, const Hit &hit, const Vec3 &direction) {
  const HotTriangle &triangle = geometry.triangles[index];
  const TriangleAttributes &attributes = geometry.attributes[index];
  const float w0 = 1 - hit.u - hit.v, w1 = hit.u, w2 = hit.v;
  SurfacePoint point;
  // Interpolated from the vertices: closer to the triangle than origin + t * direction can be.
  point.position = w0 * triangle.v0 + w1 * triangle.v1 + w2 * triangle.v2;
  const Vec3 &geometric = triangle.flatNormal;
  const bool counterClockwise = glm::dot(geometric, direction) < 0;
  point.front = meetsFront(triangle.flags, geometric, direction);
  point.flatNormal = counterClockwise ? geometric : -geometric;
  point.safeOffset = triangle.safeOffset;

  point.normal = point.flatNormal;
  if (triangle.flags & kHasNormals) {
    const Vec3 sum = w0 * attributes.normal[0] + w1 * attributes.normal[1] + w2 * attributes.normal[2];
    const Vec3 smooth = normalizedOr(sum, point.flatNormal);
    point.normal = glm::dot(smooth, point.flatNormal) < 0 ? -smooth : smooth;
  }
  if (triangle.flags & kHasColors) {
    point.color = w0 * attributes.color[0] + w1 * attributes.color[1] + w2 * attributes.color[2];
  }
  point.uv = w0 * attributes.uv[0] + w1 * attributes.uv[1] + w2 * attributes.uv[2];
  return point;
}

}  // namespace rc::hal
