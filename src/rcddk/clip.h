// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// clip.h: triangles against clip planes, once, when they are drawn: every ray then sees the cut, and tracing does not
// pay for it. [OpenGL ES 1.1, 2.12]
// Sutherland, Hodgman: "Reentrant Polygon Clipping", CACM 17(1), 1974.
#pragma once

#include <array>
#include <span>

#include "base/vec.h"

namespace rc::ddk {

// A vertex in world space with what is interpolated between vertices.
struct Corner {
  Vec3 position{0}, normal{0};
  Vec2 uv{0};
  Rgb color{0};
};

class Clipper {
 public:
  static constexpr size_t kMostPlanes = 6;

  // The polygon that is left, in the triangle's winding; empty where nothing is. Valid until the next call.
  std::span<const Corner> clip(std::span<const Corner, 3> triangle, std::span<const Vec4> planes);

 private:
  static constexpr size_t kMostCorners = 3 + kMostPlanes;  // each plane adds one at most
  std::array<Corner, kMostCorners> mPolygon, mCut;
};

}  // namespace rc::ddk
