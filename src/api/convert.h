// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// convert.h: numbers across the API: 16.16 fixed point, clamping, rounding that never overflows.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "RC/rctypes.h"
#include "base/vec.h"

namespace rc::api {

inline float fromFixed(RCfixed value) { return static_cast<float>(value / 65536.0); }

// The first N of an array of fixed-point values.
template <size_t N>
std::array<float, N> fromFixed(const RCfixed *values) {
  std::array<float, N> result;
  for (size_t i = 0; i < N; ++i) result[i] = fromFixed(values[i]);
  return result;
}

// To the nearest integer; out of range values saturate, and what is not a number becomes 0.
inline RCint roundToInt(double value) {
  if (std::isnan(value)) return 0;
  constexpr double lowest = std::numeric_limits<RCint>::min(), highest = std::numeric_limits<RCint>::max();
  return static_cast<RCint>(std::lround(std::fmin(std::fmax(value, lowest), highest)));
}

inline RCfixed toFixed(double value) { return roundToInt(value * 65536); }

// 0 ... 1 spans the integers from 0 on. [OpenGL ES 1.1, 2.6, 6.1.2]
inline RCint toSpannedInt(double value) { return roundToInt(std::fmax((value * 4294967295.0 - 1) / 2, 0)); }

// To 0 ... 1; what is not a number becomes 0.
inline float clamp01(float value) { return value > 0 ? std::fmin(value, 1.0f) : 0.0f; }
inline Rgb clamp01(const float *rgb) { return {clamp01(rgb[0]), clamp01(rgb[1]), clamp01(rgb[2])}; }

}  // namespace rc::api
