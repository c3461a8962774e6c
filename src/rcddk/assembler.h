// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// assembler.h: the triangles of a draw call, one after the other: transformed, skinned, clipped.
// In: DrawCall, numbers of vertices.  Out: rows of triangles and attributes.  Next: rcddk/geometry.cpp
#pragma once

#include "rcddk/clip.h"
#include "rcddk/vertex_fetch.h"

namespace rc::ddk {

// Where triangles go. There is room for what may come: kMostOfClipped for each that is clipped, else one.
struct Assembled {
  static constexpr size_t kMostOfClipped = 7;

  hal::HotTriangle *triangles;
  hal::TriangleAttributes *attributes;
  size_t count = 0;
  SkippedTriangles skipped;
};

// Inverse transpose of the upper 3 x 3 up to a positive factor; defined for singular matrices too.
inline glm::mat3 normalMatrix(const Mat4 &worldFromObject) {
  const Vec3 x(worldFromObject[0]), y(worldFromObject[1]), z(worldFromObject[2]);
  const glm::mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < 0 ? -cofactors : cofactors;
}

// The matrix that skins a vertex: the sum of the palette's matrices by weight. [reference 4.7]
inline Mat4 blend(const DrawCall &call, size_t element) {
  Mat4 sum(0);
  for (size_t k = 0; k < std::min(call.matrixIndices.components, call.weights.components); ++k) {
    const float index = component(call.matrixIndices, element, k);
    if (index < static_cast<float>(call.palette.size())) {
      sum += component(call.weights, element, k) * call.palette[static_cast<size_t>(index)];
    }
  }
  return sum;
}

class Assembler {
 public:
  Assembler(const DrawCall &call, const Assembled &out)
      : mCall(call), mOut(out), mNormalMatrix(normalMatrix(call.worldFromObject)) {
    for (const ArrayView *array : {&call.vertices, &call.normals, &call.texCoords, &call.colors}) {
      if (array->data) mElements = std::min(mElements, array->elements);
    }
    if (call.palette.empty()) return;
    mElements = std::min({mElements, call.matrixIndices.elements, call.weights.elements});
  }

  const Assembled &result() const { return mOut; }

  // A triangle of the draw call; `last` is the vertex that counts where shading is flat.
  void add(size_t i0, size_t i1, size_t i2, size_t last) {
    const size_t elements[3] = {loadIndex(mCall.indices, i0), loadIndex(mCall.indices, i1),
                                loadIndex(mCall.indices, i2)};
    const size_t shading = mCall.flatShading ? loadIndex(mCall.indices, last) : 0;
    for (const size_t element : {elements[0], elements[1], elements[2], shading}) {
      if (element >= mElements) return void(++mOut.skipped.noData);
    }
    Corner corners[3];
    for (size_t i = 0; i < 3; ++i) corners[i] = corner(elements[i], mCall.flatShading ? shading : elements[i]);
    const bool finite = isFinite(corners[0].position + corners[1].position + corners[2].position);
    if (mCall.clipPlanes.empty() || !finite) return addTriangle(corners[0], corners[1], corners[2]);
    const std::span<const Corner> left = mClipper.clip(corners, mCall.clipPlanes);
    if (left.empty()) ++mOut.skipped.clipped;
    for (size_t i = 2; i < left.size(); ++i) addTriangle(left[0], left[i - 1], left[i]);
  }

 private:
  Corner corner(size_t element, size_t shading) const {
    Corner corner{.position = position(element), .uv = texCoord(element)};
    if (mCall.normals.data) corner.normal = normal(shading);
    if (mCall.colors.data) corner.color = glm::clamp(loadColor(mCall.colors, shading), 0.0f, 1.0f);
    return corner;
  }

  void addTriangle(const Corner &a, const Corner &b, const Corner &c) {
    const Corner *corners[3] = {&a, &b, &c};
    hal::HotTriangle triangle{
        a.position, b.position, c.position, mCall.material, mCall.flags & ~uint32_t{hal::kTangentFrame}, 0};
    const Vec3 edges = glm::cross(b.position - a.position, c.position - a.position);
    if (!isFinite(a.position + b.position + c.position) || !isFinite(edges)) return void(++mOut.skipped.notFinite);
    // Without area as far as float can tell: the hit point would have no normal.
    if (!(glm::length(edges) > 0)) return void(++mOut.skipped.degenerate);

    hal::TriangleAttributes attributes{};
    for (size_t i = 0; i < 3; ++i) {
      attributes.uv[i] = corners[i]->uv;
      attributes.color[i] = corners[i]->color;
    }
    if (mCall.colors.data) triangle.flags |= hal::kHasColors;
    if (mCall.flags & hal::kTangentFrame) {
      if (setTangentFrame(triangle, edges, attributes)) triangle.flags |= hal::kTangentFrame;
    } else if (mCall.normals.data && setNormals(corners, edges, attributes)) {
      triangle.flags |= hal::kHasNormals;
    }
    hal::setPlane(triangle, attributes);
    mOut.triangles[mOut.count] = triangle;
    mOut.attributes[mOut.count] = attributes;
    ++mOut.count;
  }

  // The palette acts after the modelview matrix.
  Vec3 position(size_t element) const {
    const Vec4 world = mCall.worldFromObject * Vec4(loadVec3(mCall.vertices, element), 1);
    return Vec3(mCall.palette.empty() ? world : blend(mCall, element) * world);
  }

  Vec3 normal(size_t element) const {
    const Vec3 world = mNormalMatrix * loadVec3(mCall.normals, element);
    return mCall.palette.empty() ? world : normalMatrix(blend(mCall, element)) * world;
  }

  Vec2 texCoord(size_t element) const {
    const Vec4 given = mCall.texCoords.data ? Vec4(loadVec2(mCall.texCoords, element), 0, 1) : mCall.texCoord;
    const Vec4 coordinate = mCall.textureMatrix * given;
    const float q = coordinate.w != 0 ? coordinate.w : 1;
    return Vec2(coordinate) / q;
  }

  // False where no corner has a usable normal; a corner without one gets the flat normal.
  static bool setNormals(const Corner *const (&corners)[3], const Vec3 &edges, hal::TriangleAttributes &attributes) {
    const Vec3 flat = glm::normalize(edges);
    bool usable = false;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 given = corners[i]->normal;
      const bool valid = isFinite(given) && glm::length(given) > 0;
      attributes.normal[i] = valid ? normalizedOr(given, flat) : flat;
      usable |= valid;
    }
    return usable;
  }

  // Directions in which s and t grow, and the flat normal; false where the texture coordinates span nothing.
  // [reference 4.5]
  static bool setTangentFrame(const hal::HotTriangle &triangle, const Vec3 &edges,
                              hal::TriangleAttributes &attributes) {
    const Vec3 e1 = triangle.v1 - triangle.v0, e2 = triangle.v2 - triangle.v0;
    const Vec2 d1 = attributes.uv[1] - attributes.uv[0], d2 = attributes.uv[2] - attributes.uv[0];
    const float turn = d1.x * d2.y - d2.x * d1.y;
    if (turn == 0 || !std::isfinite(turn)) return false;
    const float sign = turn > 0 ? 1.0f : -1.0f;
    const Vec3 none(0);
    const Vec3 tangent = normalizedOr(sign * (d2.y * e1 - d1.y * e2), none);
    const Vec3 bitangent = normalizedOr(sign * (d1.x * e2 - d2.x * e1), none);
    if (tangent == none || bitangent == none) return false;
    attributes.normal[0] = tangent;
    attributes.normal[1] = bitangent;
    attributes.normal[2] = glm::normalize(edges);
    return true;
  }

  const DrawCall &mCall;
  Assembled mOut;
  glm::mat3 mNormalMatrix;
  size_t mElements = SIZE_MAX;  // that every array has
  Clipper mClipper;
};

}  // namespace rc::ddk
