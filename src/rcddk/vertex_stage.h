// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vertex_stage.h: what happens to vertices one by one, many side by side: they and their normals are transformed.
// The operations are GLM's in GLM's order, so the bits are the same on every instruction set.
#pragma once

#include <cstddef>

#include "base/vec.h"

namespace rc::ddk {

struct VertexColumns {
  static constexpr size_t kMost = 192;         // vertices: those of 64 triangles
  static constexpr size_t kRoom = kMost + 16;  // a vector may reach beyond the last one

  // Zeros, since arithmetic with what memory happens to hold behind the last vertex takes longer than writing them.
  alignas(64) float position[3][kRoom] = {};
  alignas(64) float normal[3][kRoom] = {};
};

// The first `count` positions become matrix * (position, 1), without a division.
void transformPositions(const Mat4 &matrix, size_t count, VertexColumns &vertices);

// The first `count` normals become matrix * normal, as long as 1; 0 where that has no direction.
void transformNormals(const glm::mat3 &matrix, size_t count, VertexColumns &vertices);

}  // namespace rc::ddk
