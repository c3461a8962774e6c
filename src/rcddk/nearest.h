// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// nearest.h: how near to a point a surface comes.
#pragma once

#include "rchal/scene_view.h"

namespace rc::ddk {

// Distance to the nearest triangle, but for rounding; through a KD-tree, to the box of all triangles. Infinite where
// there are none.
float nearestSurface(const hal::GeometryView &geometry, const Vec3 &point);

}  // namespace rc::ddk
