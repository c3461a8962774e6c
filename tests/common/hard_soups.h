// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// hard_soups.h: triangles that builders of structures find hard, as many as one likes: nothing tells them apart, every
// box overlaps every other, or one plane separates only a few.
#pragma once

#include "common/meshes.h"

namespace rc::test {

struct HardSoup {
  const char *name;
  hal::HotTriangle (*make)(size_t i, size_t count);
};

// A number from 0 to 1 that looks like chance.
inline float scattered(size_t i, uint32_t salt) {
  uint32_t x = uint32_t(i) * 2654435761u + salt * 40503u;
  x = (x ^ x >> 15) * 2246822519u;
  x = (x ^ x >> 13) * 3266489917u;
  return float((x ^ x >> 16) >> 8) * 0x1p-24f;
}
inline Vec3 scatteredPoint(size_t i, uint32_t salt) {
  return {scattered(i, salt), scattered(i, salt + 1), scattered(i, salt + 2)};
}

inline constexpr HardSoup kHardSoups[] = {
    {"equal",
     [](size_t, size_t) {
       return triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 1});
     }},
    {"coplanar",
     [](size_t i, size_t) {
       const Vec3 a = scatteredPoint(i, 1) * Vec3(1, 0, 1);
       return triangle(a, a + Vec3(0.01f, 0, 0), a + Vec3(0, 0, 0.01f));
     }},
    {"needles",  // across everything
     [](size_t i, size_t) {
       const Vec3 a = scatteredPoint(i, 1), b = Vec3(1) - a;
       return triangle(a, b, b + 1e-4f * scatteredPoint(i, 4));
     }},
    {"nested",  // around one point, each a little larger
     [](size_t i, size_t count) {
       const float size = float(i + 1) / float(count);
       return triangle({-size, -size, -size}, {size, -size, size}, {0, size, 0});
     }},
    {"spaced",  // by factors: a plane in the middle leaves nearly all on one side
     [](size_t i, size_t count) {
       const float x = std::exp2(-100 * float(i) / float(count));
       return triangle({x, 0, 0}, {x, x, 0}, {x, 0, x});
     }},
    {"scattered",
     [](size_t i, size_t count) {
       const Vec3 a = scatteredPoint(i, 1);
       const float size = 2 / std::cbrt(float(count));
       return triangle(a, a + size * scatteredPoint(i, 4), a + size * scatteredPoint(i, 7));
     }},
};

inline Triangles makeSoup(const HardSoup &soup, size_t count) {
  Triangles triangles;
  triangles.reserve(count);
  for (size_t i = 0; i < count; ++i) triangles.push_back(soup.make(i, count));
  return triangles;
}

}  // namespace rc::test
