// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vec.h: the vectors and matrices of the project: GLM's, under the names that the code uses.
// Spaces are said by variable names: worldFromObject * pointInObject. Colours are linear RGB, 0 ... 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace rc {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat4 = glm::mat4;  // column-major, as in the API
using Rgb = glm::vec3;

static_assert(sizeof(Vec3) == 12 && sizeof(Vec2) == 8, "hot data count on packed vectors");

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline bool isFinite(const Vec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline float maxComponent(const Vec3 &v) { return std::max(v.x, std::max(v.y, v.z)); }
inline float minComponent(const Vec3 &v) { return std::min(v.x, std::min(v.y, v.z)); }

// Lengths between these are those of vectors whose squares are no problem to float.
inline constexpr float kLeastPlainLength = 1e-15f, kMostPlainLength = 1e15f;

// |v|, also where its square is beyond float: of the normals of triangles 1e10 or 1e-10 large.
inline float lengthOf(const Vec3 &v) {
  const float length = glm::length(v);
  if (length > kLeastPlainLength && length < kMostPlainLength) return length;
  const float largest = maxComponent(glm::abs(v));
  return largest > 0 && largest < kInfinity ? largest * glm::length(v / largest) : length;
}

// v / length, or fallback where v has no direction. One division for three: rays and lights are rarely where the last
// bit shows.
inline Vec3 directionOf(const Vec3 &v, float length, const Vec3 &fallback) {
  return length > 0 && length < kInfinity ? v * (1 / length) : fallback;
}
inline Vec3 directionOf(const Vec3 &v, const Vec3 &fallback) { return directionOf(v, glm::length(v), fallback); }

// v / |v|, or fallback where v has no direction.
inline Vec3 normalizedOr(const Vec3 &v, const Vec3 &fallback) {
  const float length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : fallback;
}

}  // namespace rc
