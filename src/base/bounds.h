// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bounds.h: an axis-aligned box, empty until something is added.
#pragma once

#include "base/vec.h"

namespace rc {

struct Bounds {
  Vec3 lower{kInfinity};
  Vec3 upper{-kInfinity};

  void add(const Vec3 &point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void add(const Bounds &other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  bool empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  Vec3 size() const { return upper - lower; }
  Vec3 centre() const { return 0.5f * (lower + upper); }

  // Half the surface area; what the surface area heuristic weighs boxes by. In double: the squares of large
  // coordinates are beyond float.
  double halfArea() const {
    if (empty()) return 0;
    const glm::dvec3 s = glm::dvec3(upper) - glm::dvec3(lower);
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

inline Bounds intersection(const Bounds &a, const Bounds &b) {
  return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

}  // namespace rc
