// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vertex_stage.h: what happens to triangles one by one, many side by side: their corners and normals are transformed,
// and they get planes. The operations are GLM's in GLM's order, so the bits are the same on every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/vec.h"

namespace rc::ddk {

// Some triangles, a lane each.
struct TriangleColumns {
  static constexpr size_t kMost = 64;
  static constexpr size_t kRoom = kMost + 16;  // a vector may reach beyond the last one

  // By corner and axis. Zeros, since arithmetic with what memory happens to hold behind the last triangle takes longer
  // than writing them.
  alignas(64) float position[3][3][kRoom] = {};
  alignas(64) float normal[3][3][kRoom] = {};  // 0: none
  alignas(64) float uv[3][2][kRoom], color[3][3][kRoom];
  // Of setPlanes(). An area that is no finite number: nor are the corners, or they are too far apart.
  alignas(64) float flatNormal[3][kRoom], doubleArea[kRoom], safeOffset[kRoom];
  // Of completeNormals(): hal::kHasNormals where some corner has one of its own, else 0.
  alignas(64) uint32_t hasNormals[kRoom] = {};
};

// The positions of the first `count` triangles become matrix * (position, 1), without a division.
void transformPositions(const Mat4 &matrix, size_t count, TriangleColumns &triangles);

// Their normals become matrix * normal, as long as 1; 0 where that has no direction.
void transformNormals(const glm::mat3 &matrix, size_t count, TriangleColumns &triangles);

// hal::planeOf() for each.
void setPlanes(size_t count, TriangleColumns &triangles);

// Corners without a normal get that of the plane, of the side which is the front.
void completeNormals(bool clockwiseFront, size_t count, TriangleColumns &triangles);

}  // namespace rc::ddk
