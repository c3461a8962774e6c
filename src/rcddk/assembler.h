// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// assembler.h: the triangles of a draw call: transformed, skinned, clipped, many side by side.
// In: DrawCall, numbers of vertices.  Out: rows of triangles and attributes.  Next: rcddk/geometry.cpp
#pragma once

#include <memory>
#include <utility>

#include "rcddk/clip.h"
#include "rcddk/skin.h"
#include "rcddk/vertex_stage.h"

namespace rc::ddk {

// Where triangles go. There is room for what may come: one for each, and one more for each clip plane.
struct Assembled {
  hal::HotTriangle *triangles;
  hal::TriangleAttributes *attributes;
  size_t count = 0;
  SkippedTriangles skipped;
};

class Assembler {
 public:
  Assembler(const DrawCall &call, const Assembled &out)
      : mCall(call), mOut(out), mNormalMatrix(normalMatrix(call.worldFromObject)) {
    for (const ArrayView *array : {&call.vertices, &call.normals, &call.texCoords, &call.colors}) {
      if (array->data) mElements = std::min(mElements, array->elements);
    }
    if (!call.palette.empty()) mElements = std::min({mElements, call.matrixIndices.elements, call.weights.elements});
    if (!call.clipPlanes.empty()) mLeft = std::make_unique<TriangleColumns>();
    const Vec2 texCoord = transformed(call.texCoord);  // where there is no array
    for (auto &corner : mDrawn.uv) {
      for (int axis = 0; axis < 2; ++axis) std::fill(std::begin(corner[axis]), std::end(corner[axis]), texCoord[axis]);
    }
  }

  // A triangle of the draw call; `last` is the vertex that counts where shading is flat.
  void add(size_t i0, size_t i1, size_t i2, size_t last) {
    const size_t numbers[] = {i0, i1, i2};
    for (size_t k = 0; k < 3; ++k) {
      const size_t vertex = loadIndex(mCall.indices, numbers[k]);
      const size_t shading = mCall.flatShading ? loadIndex(mCall.indices, last) : vertex;
      if (std::max(vertex, shading) >= mElements) return void(++mOut.skipped.noData);
      mVertices[k][mCount] = vertex;
      mShading[k][mCount] = shading;
    }
    if (++mCount == TriangleColumns::kMost) finishDrawn();
  }

  // All that was added.
  const Assembled &result() {
    finishDrawn();
    return mOut;
  }

 private:
  // To and from columns of the lane.
  template <size_t kAxes, class Vector>
  static void put(const Vector &v, size_t lane, float (&columns)[kAxes][TriangleColumns::kRoom]) {
    for (int axis = 0; axis < int(kAxes); ++axis) columns[axis][lane] = v[axis];
  }
  static Vec3 vectorAt(const float (&columns)[3][TriangleColumns::kRoom], size_t lane) {
    return {columns[0][lane], columns[1][lane], columns[2][lane]};
  }
  static Vec2 vectorAt(const float (&columns)[2][TriangleColumns::kRoom], size_t lane) {
    return {columns[0][lane], columns[1][lane]};
  }

  // Elements of arrays, loaded one by one.
  template <size_t kAxes, class Load>
  void fetch(const size_t *elements, float (&columns)[kAxes][TriangleColumns::kRoom], Load &&load) const {
    for (size_t i = 0, count = mCount; i < count; ++i) put(load(elements[i]), i, columns);
  }

  void fetchCorners(size_t k) {
    const bool skinned = !mCall.palette.empty();
    const size_t *const vertices = mVertices[k], *const shading = mShading[k];
    if (skinned) {
      fetch(vertices, mDrawn.position[k], [&](size_t i) { return skinnedPosition(mCall, i); });
    } else {
      fetch(vertices, mDrawn.position[k], [&](size_t i) { return loadVec3(mCall.vertices, i); });
    }
    if (mCall.normals.data && skinned) {
      fetch(shading, mDrawn.normal[k], [&](size_t i) { return skinnedNormal(mCall, mNormalMatrix, i); });
    } else if (mCall.normals.data) {
      fetch(shading, mDrawn.normal[k], [&](size_t i) { return loadVec3(mCall.normals, i); });
    }
    if (mCall.texCoords.data && mMovesTexCoords) {
      fetch(vertices, mDrawn.uv[k], [&](size_t i) { return transformed(Vec4(loadVec2(mCall.texCoords, i), 0, 1)); });
    } else if (mCall.texCoords.data) {
      fetch(vertices, mDrawn.uv[k], [&](size_t i) { return loadVec2(mCall.texCoords, i); });
    }
    if (!mCall.colors.data) return;
    fetch(shading, mDrawn.color[k], [&](size_t i) { return glm::clamp(loadColor(mCall.colors, i), 0.0f, 1.0f); });
  }

  void finishDrawn() {
    for (size_t k = 0; k < 3; ++k) fetchCorners(k);
    const size_t count = std::exchange(mCount, 0);
    if (mCall.palette.empty()) {
      transformPositions(mCall.worldFromObject, count, mDrawn);
      if (mCall.normals.data) transformNormals(mNormalMatrix, count, mDrawn);
    }
    if (!mLeft) return finish(mDrawn, count);
    if (mCall.normals.data) complete(mDrawn, count);
    for (size_t i = 0; i < count; ++i) clip(i);
    finish(*mLeft, std::exchange(mLeftCount, 0));
  }

  void complete(TriangleColumns &columns, size_t count) const {
    setPlanes(count, columns);
    if (mCall.normals.data) completeNormals(mCall.flags & hal::kClockwiseFront, count, columns);
  }

  // What the clip planes leave of a triangle joins those that are left. Each of its corners has a normal then, or none
  // has: the cut gets what lies between them, at the length that it has there, and what is left is shaded as it was.
  void clip(size_t i) {
    Corner corners[3];
    for (size_t k = 0; k < 3; ++k) {
      corners[k].position = vectorAt(mDrawn.position[k], i);
      if (mDrawn.hasNormals[i]) corners[k].normal = vectorAt(mDrawn.normal[k], i);
      corners[k].uv = vectorAt(mDrawn.uv[k], i);
      if (mCall.colors.data) corners[k].color = vectorAt(mDrawn.color[k], i);
    }
    const auto &[a, b, c] = corners;
    if (!isFinite(a.position + b.position + c.position)) return leave(a, b, c);  // to be counted
    const std::span<const Corner> left = mClipper.clip(corners, mCall.clipPlanes);
    if (left.empty()) ++mOut.skipped.clipped;
    for (size_t k = 2; k < left.size(); ++k) leave(left[0], left[k - 1], left[k]);
  }

  void leave(const Corner &a, const Corner &b, const Corner &c) {
    const Corner *const corners[] = {&a, &b, &c};
    for (size_t k = 0; k < 3; ++k) {
      put(corners[k]->position, mLeftCount, mLeft->position[k]);
      put(corners[k]->normal, mLeftCount, mLeft->normal[k]);
      put(corners[k]->uv, mLeftCount, mLeft->uv[k]);
      put(corners[k]->color, mLeftCount, mLeft->color[k]);
    }
    if (++mLeftCount == TriangleColumns::kMost) finish(*mLeft, std::exchange(mLeftCount, 0));
  }

  void finish(TriangleColumns &columns, size_t count) {
    complete(columns, count);
    for (size_t i = 0; i < count; ++i) {
      const float area = columns.doubleArea[i];
      if (!std::isfinite(area)) {
        ++mOut.skipped.notFinite;
      } else if (area == 0) {  // as far as float can tell: the hit point would have no normal
        ++mOut.skipped.degenerate;
      } else {
        write(columns, i, mOut.triangles[mOut.count], mOut.attributes[mOut.count]);
        ++mOut.count;
      }
    }
  }

  void write(const TriangleColumns &columns, size_t i, hal::HotTriangle &triangle,
             hal::TriangleAttributes &attributes) const {
    const bool hasNormals = mCall.normals.data, wantsFrame = mCall.flags & hal::kTangentFrame;
    triangle.v0 = vectorAt(columns.position[0], i);
    triangle.v1 = vectorAt(columns.position[1], i);
    triangle.v2 = vectorAt(columns.position[2], i);
    triangle.material = mCall.material;
    triangle.flags = mCall.flags & ~uint32_t{hal::kTangentFrame};
    hal::setPlane({vectorAt(columns.flatNormal, i), columns.doubleArea[i], columns.safeOffset[i]}, triangle);
    const Vec3 front = frontOf(triangle.flatNormal);
    for (size_t k = 0; k < 3; ++k) {
      attributes.normal[k] = hasNormals ? vectorAt(columns.normal[k], i) : front;
      attributes.uv[k] = vectorAt(columns.uv[k], i);
    }
    if (mCall.colors.data) {  // else nobody asks, and memory need not take them
      for (size_t k = 0; k < 3; ++k) attributes.color[k] = vectorAt(columns.color[k], i);
      triangle.flags |= hal::kHasColors;
    }
    if (!wantsFrame) {
      triangle.flags |= columns.hasNormals[i];
    } else if (setTangentFrame(triangle, front, attributes)) {
      triangle.flags |= hal::kTangentFrame;
    }
  }

  Vec2 transformed(const Vec4 &texCoord) const {
    const Vec4 coordinate = mCall.textureMatrix * texCoord;
    const float q = coordinate.w != 0 ? coordinate.w : 1;
    return Vec2(coordinate) / q;
  }

  // Of the side that rcFrontFace calls the front.
  Vec3 frontOf(const Vec3 &flatNormal) const { return mCall.flags & hal::kClockwiseFront ? -flatNormal : flatNormal; }

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
  // Triangles that are transformed together: the elements of arrays that their corners have their positions and
  // texture coordinates, and their normals and colours of.
  size_t mVertices[3][TriangleColumns::kMost], mShading[3][TriangleColumns::kMost];
  TriangleColumns mDrawn;
  size_t mCount = 0;
  Clipper mClipper;
  std::unique_ptr<TriangleColumns> mLeft;  // what clip planes leave of them; null where there are none
  size_t mLeftCount = 0;
};

}  // namespace rc::ddk
