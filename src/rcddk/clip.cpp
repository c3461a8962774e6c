// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/clip.h"

#include <algorithm>

namespace rc::ddk {
namespace {

Corner between(const Corner &a, const Corner &b, float share) {
  return {glm::mix(a.position, b.position, share), glm::mix(a.normal, b.normal, share), glm::mix(a.uv, b.uv, share),
          glm::mix(a.color, b.color, share)};
}

// Where the edge crosses the plane. From the side that stays, so that neighbours compute the same point.
Corner crossing(const Corner &a, float heightA, const Corner &b, float heightB) {
  return heightA >= 0 ? between(a, b, heightA / (heightA - heightB)) : between(b, a, heightB / (heightB - heightA));
}

}  // namespace

std::span<const Corner> Clipper::clip(std::span<const Corner, 3> triangle, std::span<const Vec4> planes) {
  size_t count = 3;
  std::copy(triangle.begin(), triangle.end(), mPolygon.begin());
  for (const Vec4 &plane : planes) {
    const auto height = [&](const Corner &corner) { return glm::dot(plane, Vec4(corner.position, 1)); };
    size_t kept = 0;
    // Rounding can make a polygon with a dent, and a corner more than there is room for: it is left out.
    const auto keep = [&](const Corner &corner) {
      if (kept < kMostCorners) mCut[kept++] = corner;
    };
    for (size_t i = 0; i < count; ++i) {
      const Corner &a = mPolygon[i], &b = mPolygon[(i + 1) % count];
      const float heightA = height(a), heightB = height(b);
      if (heightA >= 0) keep(a);
      if ((heightA >= 0) != (heightB >= 0)) keep(crossing(a, heightA, b, heightB));
    }
    count = kept;
    std::swap(mPolygon, mCut);
  }
  return std::span(mPolygon).first(count >= 3 ? count : 0);
}

}  // namespace rc::ddk
