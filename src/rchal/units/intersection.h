// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// intersection.h: one ray against one triangle, watertight: a ray that meets the common edge of two
// triangles hits at least one of them.
// Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
// In: ShearedRay, HotTriangle.  Out: t and the weights of the vertices.  Next: units/traversal.h
#pragma once

#include <utility>

#include "rchal/device.h"

namespace rc::hal {

// The axis along which a direction is longest.
inline int mainAxis(const Vec3 &direction) {
  const Vec3 a = glm::abs(direction);
  return a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
}

// A ray with what all its triangle tests share: the axis permutation and shear that turn its direction into +z.
struct ShearedRay {
  Vec3 origin;
  int kx, ky, kz;
  float sx, sy, sz;

  explicit ShearedRay(const Ray &ray) : origin(ray.origin) {
    const Vec3 d = ray.direction;
    kz = mainAxis(d);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (d[kz] < 0) std::swap(kx, ky);  // keeps the winding
    sz = 1.0f /
         d[kz];  // the one division: which way the last bit falls is no matter as long as all triangles see the same
    sx = d[kx] * sz;
    sy = d[ky] * sz;
  }
};

// On a hit at any t sets t, u, v of `hit` and returns true; the caller decides whether t is of interest.
inline bool intersectTriangle(const ShearedRay &ray, const HotTriangle &triangle, Hit &hit) {
  const Vec3 a = triangle.v0 - ray.origin, b = triangle.v1 - ray.origin, c = triangle.v2 - ray.origin;
  const float ax = a[ray.kx] - ray.sx * a[ray.kz], ay = a[ray.ky] - ray.sy * a[ray.kz];
  const float bx = b[ray.kx] - ray.sx * b[ray.kz], by = b[ray.ky] - ray.sy * b[ray.kz];
  const float cx = c[ray.kx] - ray.sx * c[ray.kz], cy = c[ray.ky] - ray.sy * c[ray.kz];

  float wa = cx * by - cy * bx;
  float wb = ax * cy - ay * cx;
  float wc = bx * ay - by * ax;
  // Exactly on an edge as far as float can tell: double decides, the same way for both neighbours.
  if (wa == 0 || wb == 0 || wc == 0) {
    wa = static_cast<float>(double(cx) * double(by) - double(cy) * double(bx));
    wb = static_cast<float>(double(ax) * double(cy) - double(ay) * double(cx));
    wc = static_cast<float>(double(bx) * double(ay) - double(by) * double(ax));
  }
  if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) return false;
  const float determinant = wa + wb + wc;
  if (determinant == 0) return false;  // the ray lies in the triangle's plane

  const float scale = 1.0f / determinant;
  hit.t = (wa * a[ray.kz] + wb * b[ray.kz] + wc * c[ray.kz]) * ray.sz * scale;
  hit.u = wb * scale;
  hit.v = wc * scale;
  return true;
}

}  // namespace rc::hal
