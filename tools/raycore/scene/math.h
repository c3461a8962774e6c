// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// math.h: vectors, matrices and colours as the tool uses them.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace rc::tool {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat4 = glm::mat4;
using Quat = glm::quat;

inline float maxOf(const Vec3 &v) { return glm::max(v.x, glm::max(v.y, v.z)); }

// Display values: what RayCore computes with, and what its pictures hold. [IEC 61966-2-1]
inline float encoded(float linear) {
  const float c = glm::clamp(linear, 0.0f, 1.0f);
  return c <= 0.0031308f ? 12.92f * c : 1.055f * glm::pow(c, 1 / 2.4f) - 0.055f;
}
inline Vec3 encoded(const Vec3 &linear) { return {encoded(linear.x), encoded(linear.y), encoded(linear.z)}; }

struct Bounds {
  Vec3 low{std::numeric_limits<float>::max()};
  Vec3 high{std::numeric_limits<float>::lowest()};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void add(const Vec3 &point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  Vec3 centre() const { return empty() ? Vec3(0) : 0.5f * (low + high); }
  Vec3 size() const { return empty() ? Vec3(0) : high - low; }
  float radius() const { return 0.5f * glm::length(size()); }
};

}  // namespace rc::tool
