// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// skin.h: vertices that follow the matrices of a palette, which act after the modelview matrix. [reference 4.7]
#pragma once

#include "rcddk/vertex_fetch.h"

namespace rc::ddk {

// Inverse transpose of the upper 3 x 3 up to a positive factor; defined for singular matrices too.
inline glm::mat3 normalMatrix(const Mat4 &worldFromObject) {
  const Vec3 x(worldFromObject[0]), y(worldFromObject[1]), z(worldFromObject[2]);
  const glm::mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < 0 ? -cofactors : cofactors;
}

// The matrix that skins a vertex: the sum of the palette's matrices by weight.
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

inline Vec3 skinnedPosition(const DrawCall &call, size_t element) {
  const Vec4 world = call.worldFromObject * Vec4(loadVec3(call.vertices, element), 1);
  return Vec3(blend(call, element) * world);
}

// worldFromNormal: normalMatrix() of the call's.
inline Vec3 skinnedNormal(const DrawCall &call, const glm::mat3 &worldFromNormal, size_t element) {
  const Vec3 world = worldFromNormal * loadVec3(call.normals, element);
  return normalizedOr(normalMatrix(blend(call, element)) * world, Vec3(0));
}

}  // namespace rc::ddk
