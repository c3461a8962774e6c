// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// framebuffer.h: colours to bytes, and the part of the target that no ray reaches. [spec 3.1, 4]
#pragma once

#include "rchal/device.h"

namespace rc::hal {

// min(255, floor(256 c)) for each channel, alpha 255: how the hardware stores colours. No gamma.
inline uint32_t packColour(const Rgb &colour) {
  const auto byte = [](float c) { return c > 0 ? std::min(255u, static_cast<uint32_t>(std::min(c, 1.0f) * 256)) : 0u; };
  return byte(colour.x) | byte(colour.y) << 8 | byte(colour.z) << 16 | 0xff000000u;
}

// Fills what lies right of or above the viewport with the clear colour.
void clearOutsideViewport(const SceneView &scene, const Target &target);

// Columns and rows of the picture that are both in the viewport and on the target.
struct Visible {
  int columns, rows;
};
Visible visiblePart(const SceneView &scene, const Target &target);

}  // namespace rc::hal
