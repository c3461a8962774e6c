// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rgb.h: pixels as files without opacity have them.
#pragma once

#include "scene/scene.h"

namespace rc::tool {

inline std::vector<uint8_t> rgbOf(const Image &image) {
  std::vector<uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (size_t i = 0; i < image.rgba.size(); i += 4) rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
  return rgb;
}

}  // namespace rc::tool
