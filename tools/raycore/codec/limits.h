// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// limits.h: what pictures may be.
#pragma once

#include <cstdint>

#include "input/error.h"

namespace rc::tool {

inline constexpr int kLargestSide = 16384;

// Throws InputError.
inline void checkPictureSize(int64_t width, int64_t height) {
  if (width < 1 || height < 1) reject("the picture has no pixels");
  if (width > kLargestSide || height > kLargestSide) {
    reject("the picture is {} x {}, the largest side is {}", width, height, kLargestSide);
  }
}

}  // namespace rc::tool
