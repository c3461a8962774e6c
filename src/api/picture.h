// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// picture.h: pixels of a traced picture, by place.
#pragma once

#include "rchal/framebuffer.h"

namespace rc::api {

// The pixel of a column and a row counted from the bottom; null beside the picture.
inline const uint32_t *pictureAt(const hal::Target &picture, int64_t column, int64_t row) {
  const bool inside = column >= 0 && column < picture.width && row >= 0 && row < picture.height;
  return inside ? &hal::pixelAt(picture, static_cast<int>(column), static_cast<int>(row)) : nullptr;
}

}  // namespace rc::api
