// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// assembler.h: the triangles of a draw call: transformed, skinned, clipped.
// In: DrawCall, numbers of vertices.  Out: rows of triangles and attributes.  Next: rcddk/geometry.cpp
#pragma once

#include "rcddk/clip.h"
#include "rcddk/vertex_fetch.h"
#include "rcddk/vertex_stage.h"

namespace rc::ddk {

// Where triangles go. There is room for what may come: one for each, and one more for each clip plane.
struct Assembled {
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
    if (!call.texCoords.data) mTexCoord = transformed(call.texCoord);
    if (call.palette.empty()) return;
    mElements = std::min({mElements, call.matrixIndices.elements, call.weights.elements});
  }

  // A triangle of the draw call; `last` is the vertex that counts where shading is flat.
  void add(size_t i0, size_t i1, size_t i2, size_t last) {
    Elements &elements = mWaiting[mCount];
    elements = {{loadIndex(mCall.indices, i0), loadIndex(mCall.indices, i1), loadIndex(mCall.indices, i2)}, {}};
    for (size_t i = 0; i < 3; ++i) {
      elements.shading[i] = mCall.flatShading ? loadIndex(mCall.indices, last) : elements.vertices[i];
      if (std::max(elements.vertices[i], elements.shading[i]) >= mElements) return void(++mOut.skipped.noData);
    }
    if (++mCount == kWaiting) finishWaiting();
  }

  // All that was added.
  const Assembled &result() {
    finishWaiting();
    return mOut;
  }

 private:
  static constexpr size_t kWaiting = VertexColumns::kMost / 3;

  // Of the arrays: where the corners of a triangle have their positions, and where their normals and colours.
  struct Elements {
    size_t vertices[3], shading[3];
  };

  void finishWaiting() {
    const size_t count = 3 * mCount;
    for (size_t i = 0; i < count; ++i) fetch(mWaiting[i / 3].vertices[i % 3], mWaiting[i / 3].shading[i % 3], i);
    if (mCall.palette.empty()) {
      transformPositions(mCall.worldFromObject, count, mVertices);
      if (mCall.normals.data) transformNormals(mNormalMatrix, count, mVertices);
    }
    for (size_t i = 0; i < mCount; ++i) addClipped(mWaiting[i], 3 * i);
    mCount = 0;
  }

  void fetch(size_t element, size_t shading, size_t i) {
    const bool skinned = !mCall.palette.empty();
    const Vec3 position = skinned ? skinnedPosition(element) : loadVec3(mCall.vertices, element);
    for (int axis = 0; axis < 3; ++axis) mVertices.position[axis][i] = position[axis];
    if (!mCall.normals.data) return;
    const Vec3 normal = skinned ? skinnedNormal(shading) : loadVec3(mCall.normals, shading);
    for (int axis = 0; axis < 3; ++axis) mVertices.normal[axis][i] = normal[axis];
  }

  void addClipped(const Elements &elements, size_t first) {
    const Corner a = corner(elements, 0, first), b = corner(elements, 1, first + 1), c = corner(elements, 2, first + 2);
    if (mCall.clipPlanes.empty() || !isFinite(a.position + b.position + c.position)) return addTriangle(a, b, c);
    Corner corners[3] = {a, b, c};
    if (mCall.normals.data) completeNormals(corners);
    const std::span<const Corner> left = mClipper.clip(corners, mCall.clipPlanes);
    if (left.empty()) ++mOut.skipped.clipped;
    for (size_t i = 2; i < left.size(); ++i) addTriangle(left[0], left[i - 1], left[i]);
  }

  // Inlined with addTriangle, as corners that are no array: one that goes through memory is read there in other pieces
  // than it was written in, which processors wait for.
  [[gnu::always_inline]] Corner corner(const Elements &elements, size_t i, size_t column) const {
    const auto vector = [column](const float(&columns)[3][VertexColumns::kRoom]) {
      return Vec3(columns[0][column], columns[1][column], columns[2][column]);
    };
    Corner corner{.position = vector(mVertices.position), .uv = mTexCoord};
    if (mCall.normals.data) corner.normal = vector(mVertices.normal);
    if (mCall.texCoords.data) {
      corner.uv = loadVec2(mCall.texCoords, elements.vertices[i]);
      if (mMovesTexCoords) corner.uv = transformed(Vec4(corner.uv, 0, 1));
    }
    if (mCall.colors.data) corner.color = glm::clamp(loadColor(mCall.colors, elements.shading[i]), 0.0f, 1.0f);
    return corner;
  }

  // Written where it belongs; what is skipped is written over.
  [[gnu::always_inline]] void addTriangle(const Corner &a, const Corner &b, const Corner &c) {
    const hal::TrianglePlane plane = hal::planeOf(a.position, b.position, c.position);
    const bool finite = isFinite(a.position + b.position + c.position) && std::isfinite(plane.doubleArea);
    if (!finite) return void(++mOut.skipped.notFinite);
    // Without area as far as float can tell: the hit point would have no normal.
    if (plane.doubleArea == 0) return void(++mOut.skipped.degenerate);

    hal::HotTriangle &triangle = mOut.triangles[mOut.count];
    hal::TriangleAttributes &attributes = mOut.attributes[mOut.count];
    uint32_t flags = mCall.flags & ~uint32_t{hal::kTangentFrame};
    if (mCall.colors.data) flags |= hal::kHasColors;
    triangle.v0 = a.position;
    triangle.v1 = b.position;
    triangle.v2 = c.position;
    triangle.material = mCall.material;
    hal::setPlane(plane, triangle);
    attributes.uv[0] = a.uv;
    attributes.uv[1] = b.uv;
    attributes.uv[2] = c.uv;
    if (mCall.colors.data) {  // else nobody asks, and memory need not take them
      attributes.color[0] = a.color;
      attributes.color[1] = b.color;
      attributes.color[2] = c.color;
    }
    const Vec3 front = frontOf(plane.flatNormal);
    attributes.normal[0] = normalOf(a, front);
    attributes.normal[1] = normalOf(b, front);
    attributes.normal[2] = normalOf(c, front);
    if (mCall.flags & hal::kTangentFrame) {
      if (setTangentFrame(triangle, front, attributes)) flags |= hal::kTangentFrame;
    } else if (hasNormal(a) || hasNormal(b) || hasNormal(c)) {
      flags |= hal::kHasNormals;
    }
    triangle.flags = flags;
    ++mOut.count;
  }

  // The palette acts after the modelview matrix.
  Vec3 skinnedPosition(size_t element) const {
    const Vec4 world = mCall.worldFromObject * Vec4(loadVec3(mCall.vertices, element), 1);
    return Vec3(blend(mCall, element) * world);
  }

  Vec3 skinnedNormal(size_t element) const {
    const Vec3 world = mNormalMatrix * loadVec3(mCall.normals, element);
    return normalizedOr(normalMatrix(blend(mCall, element)) * world, Vec3(0));
  }

  Vec2 transformed(const Vec4 &texCoord) const {
    const Vec4 coordinate = mCall.textureMatrix * texCoord;
    const float q = coordinate.w != 0 ? coordinate.w : 1;
    return Vec2(coordinate) / q;
  }

  // Of the side that rcFrontFace calls the front.
  Vec3 frontOf(const Vec3 &flatNormal) const { return mCall.flags & hal::kClockwiseFront ? -flatNormal : flatNormal; }

  static bool hasNormal(const Corner &corner) { return corner.normal != Vec3(0); }
  // A corner without a usable normal gets the flat one.
  static Vec3 normalOf(const Corner &corner, const Vec3 &front) {
    const bool own = hasNormal(corner);
    return {own ? corner.normal.x : front.x, own ? corner.normal.y : front.y, own ? corner.normal.z : front.z};
  }

  // Before a triangle is cut: each corner has its normal, so that the cut has what lies between them, at the length
  // that it has there, and what is left is shaded as it was.
  void completeNormals(Corner (&corners)[3]) const {
    const auto &[a, b, c] = corners;
    if (!hasNormal(a) && !hasNormal(b) && !hasNormal(c)) return;
    const Vec3 edges = glm::cross(b.position - a.position, c.position - a.position);
    const Vec3 front = frontOf(directionOf(edges, lengthOf(edges), Vec3(0)));
    for (Corner &corner : corners) corner.normal = normalOf(corner, front);
  }

  // Directions in which s and t grow, and the front's normal; false where the texture coordinates span nothing.
  // [reference 4.5]
  static bool setTangentFrame(const hal::HotTriangle &triangle, const Vec3 &front,
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
    attributes.normal[2] = front;
    return true;
  }

  const DrawCall &mCall;
  Assembled mOut;
  glm::mat3 mNormalMatrix;
  const bool mMovesTexCoords = mCall.textureMatrix != Mat4(1);  // mostly not
  size_t mElements = SIZE_MAX;                                  // that every array has
  Vec2 mTexCoord{0};                                            // of all vertices where there is no array
  Elements mWaiting[kWaiting];                                  // triangles whose vertices are transformed together
  size_t mCount = 0;
  VertexColumns mVertices;
  Clipper mClipper;
};

}  // namespace rc::ddk
