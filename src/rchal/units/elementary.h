// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// elementary.h: logarithm, exponential and power, good to a few units of the seventh digit. Our own, because those of
// C libraries differ from each other: here every compiler, library and vector unit computes the same bits. Polynomials
// by Estrin's scheme: few steps wait for each other.
// (rcddi/cpu/shading/elementary-inl.h does the same operations in the same order.)
#pragma once

#include <bit>
#include <cstdint>

#include "base/vec.h"

namespace rc::hal {

namespace elementary {
inline constexpr float kSmallest = 0x1p-126f;        // below: 0
inline constexpr uint32_t kHalfSquare = 0x3f3504f3;  // sqrt(1/2): mantissas run from here to sqrt(2)
// ln((1 + s) / (1 - s)) / ln 2 = s (c0 + c1 s^2 + ...)
inline constexpr float kLog2[] = {2.88539008f, 0.961796694f, 0.577078016f, 0.412198583f, 0.320598898f};
// 2^f for |f| <= 1/2: powers of ln 2 over factorials, up to f^6
inline constexpr float kExp2[] = {1.0f,           0.693147181f,   0.240226507f,   0.0555041087f,
                                  0.00961812911f, 0.00133335581f, 0.000154035304f};
}  // namespace elementary

// Logarithm to base 2; minus infinity for what has none.
inline float log2Of(float x) {
  using namespace elementary;
  if (!(x >= kSmallest)) return -kInfinity;
  const uint32_t offset = std::bit_cast<uint32_t>(x) - kHalfSquare;
  const auto exponent = static_cast<float>(static_cast<int32_t>(offset) >> 23);
  const float mantissa = std::bit_cast<float>((offset & 0x7fffff) + kHalfSquare);
  const float s = (mantissa - 1) / (mantissa + 1), s2 = s * s, s4 = s2 * s2;
  const float low = kLog2[0] + s2 * kLog2[1], high = kLog2[2] + s2 * kLog2[3];
  return exponent + s * (low + s4 * (high + s4 * kLog2[4]));
}

// 2^x; 0 below 2^-126, 2^126 above.
inline float exp2Of(float x) {
  using namespace elementary;
  if (!(x >= -126)) return 0;
  const float clamped = std::min(x, 126.0f);
  const float whole = std::floor(clamped + 0.5f), f = clamped - whole;
  const float f2 = f * f, f4 = f2 * f2;
  const auto pair = [f](int k) { return kExp2[k] + f * kExp2[k + 1]; };
  const float low = pair(0) + f2 * pair(2), high = pair(4) + f2 * kExp2[6];
  return (low + f4 * high) * std::bit_cast<float>(static_cast<uint32_t>(static_cast<int32_t>(whole) + 127) << 23);
}

// base^exponent for base >= 0, exponent >= 0; 0^0 = 1.
inline float powOf(float base, float exponent) { return exponent > 0 ? exp2Of(exponent * log2Of(base)) : 1; }

}  // namespace rc::hal
