// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shapes.h: meshes that are computed.
#pragma once

#include <functional>

#include "frames/scenes.h"

namespace rc::bench {

struct SurfacePoint {
  Vec3 position, normal;
};

// Two triangles between each four neighbours of point(u, v), both 0 ... 1; those without area are left out.
Mesh grid(int rows, int columns, const std::function<SurfacePoint(double, double)> &point);

Mesh ball(const Vec3 &centre, float radius, int rows, int columns);
Mesh quad(const Vec3 &corner, const Vec3 &right, const Vec3 &up);
Mesh box(const Vec3 &lower, const Vec3 &upper);
Mesh knot(const Vec3 &centre, float size, float thickness);  // a trefoil of 32,000 triangles

}  // namespace rc::bench
