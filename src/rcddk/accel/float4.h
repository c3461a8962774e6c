// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// float4.h: four floats in one register on every machine, by the vector extension that GCC and Clang share.
#pragma once

#include <algorithm>
#include <cstring>

namespace rc::ddk {

using Float4 = float __attribute__((vector_size(16)));

inline Float4 all(float x) { return Float4{x, x, x, x}; }
inline Float4 load4(const void *memory) {
  Float4 r;
  std::memcpy(&r, memory, sizeof r);
  return r;
}
inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 abs(Float4 a) { return max(a, -a); }

inline float least(Float4 a) {
  a = min(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
  return std::min(a[0], a[1]);
}
inline float most(Float4 a) {
  a = max(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
  return std::max(a[0], a[1]);
}

// The first three columns of four rows.
struct Columns3 {
  Float4 x, y, z;
};
inline Columns3 transpose(Float4 a, Float4 b, Float4 c, Float4 d) {
  const Float4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Float4 abUpper = __builtin_shufflevector(a, b, 2, 6, 3, 7), cdUpper = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
          __builtin_shufflevector(abUpper, cdUpper, 0, 1, 4, 5)};
}

}  // namespace rc::ddk
