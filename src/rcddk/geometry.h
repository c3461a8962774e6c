// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// geometry.h: client arrays to triangles in world space. [spec 3.6; G 7]
// In: a draw call's arrays, matrices and flags.  Out: a GeometrySet.  Next: rcddk/scene.cpp, accel/builder.h
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/rows.h"
#include "rcddk/accel/builder.h"
#include "rcddk/frame_stats.h"
#include "rcddk/material.h"

namespace rc::ddk {

enum class Component { Byte, UnsignedByte, Short, UnsignedShort, UnsignedInt, Float, Fixed };
enum class Primitive { Triangles, Quads, TriangleFan, TriangleStrip };
enum class IndexType { Sequence, Byte, Short, Int };

// A vertex array in client memory or in a buffer object; data is null where the array is off.
struct ArrayView {
  const std::byte *data = nullptr;
  Component type = Component::Float;
  size_t components = 0;       // of an element
  size_t stride = 0;           // bytes from one element to the next
  size_t elements = SIZE_MAX;  // that may be read; client memory is trusted
};

// Which elements of the arrays the vertices of a draw call are.
struct IndexView {
  IndexType type = IndexType::Sequence;  // Sequence: first, first + 1, ...
  const std::byte *data = nullptr;
  size_t first = 0;
  size_t count = 0;
};

struct DrawCall {
  Primitive primitive = Primitive::Triangles;
  IndexView indices;
  ArrayView vertices, normals, texCoords, colors;
  ArrayView matrixIndices, weights;  // of the palette
  std::span<const Mat4> palette;     // empty where there is no skinning
  Mat4 worldFromObject{1};
  Mat4 textureMatrix{1};
  Vec4 texCoord{0, 0, 0, 1};         // of all vertices where there is no array
  std::span<const Vec4> clipPlanes;  // world space; what lies on a negative side is cut off
  bool flatShading = false;          // normal and colour of a primitive's last vertex count for all of it
  uint32_t material = 0;             // as in hal::HotTriangle
  uint32_t flags = 0;                // hal::TriangleFlag, without those of the arrays; kTangentFrame is a wish
};

// The static scene or one frame's dynamic geometry.
struct GeometrySet {
  Rows<hal::HotTriangle> triangles;
  Rows<hal::TriangleAttributes> attributes;
  Array<Material> captured;  // of draws without a material object
  SkippedTriangles skipped;
  bool filtersShadow = false, interpolates = false;  // as in hal::GeometryView

  bool empty() const { return triangles.empty(); }
};

// Appends the triangles of a draw call; incomplete last primitives are dropped.
void appendTriangles(const DrawCall &call, GeometrySet &set, const Workers &workers);

}  // namespace rc::ddk
