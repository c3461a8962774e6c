// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// framebuffer.h: colours to bytes, and which pixels of the target are written and traced. [spec 3.1, 4]
#pragma once

#include "rchal/device.h"

namespace rc::hal {

// The bits of a colour that a buffer of 5, 6 and 5 bits keeps, and those that repeat the upper ones.
namespace rgb565 {
inline constexpr uint32_t kKept = 0xfff8fcf8, kRedAndBlue = 0x00070007, kGreen = 0x00000300;
}

// What is left of a colour in such a buffer; since the upper bits are repeated, full stays full.
inline uint32_t roundTo565(uint32_t rgba) {
  return (rgba & rgb565::kKept) | (rgba >> 5 & rgb565::kRedAndBlue) | (rgba >> 6 & rgb565::kGreen);
}

// min(255, floor(256 c)) for each channel, alpha 255: how the hardware stores colours. No gamma.
inline uint32_t packColour(const Rgb &colour, bool in565 = false) {
  const auto byte = [](float c) { return c > 0 ? std::min(255u, static_cast<uint32_t>(std::min(c, 1.0f) * 256)) : 0u; };
  const uint32_t rgba = byte(colour.x) | byte(colour.y) << 8 | byte(colour.z) << 16 | 0xff000000u;
  return in565 ? roundTo565(rgba) : rgba;
}

// The pixel of a column and a row counted from the bottom.
inline uint32_t &pixelAt(const Target &target, int column, int row) {
  return target.pixels[size_t(target.height - 1 - row) * size_t(target.width) + size_t(column)];
}

// Replaces the bits that may be written. [rcColorMask]
inline void store(uint32_t &pixel, uint32_t value, uint32_t writeMask) {
  pixel = (pixel & ~writeMask) | (value & writeMask);
}

// What two rectangles have in common; empty where that is nothing. Those of programs may be anywhere.
PixelRect common(const PixelRect &a, const PixelRect &b);

// Fills a part of the target with the clear colour.
void clear(const SceneView &scene, const Target &target, const PixelRect &part);

// The part of the target that a frame writes: all of it, or what the scissor box leaves. [rcScissor]
PixelRect writtenPart(const SceneView &scene, const Target &target);

// The part of it that rays are traced for: what lies in the viewport. The rest is cleared.
PixelRect tracedPart(const SceneView &scene, const Target &target);
void clearOutsideViewport(const SceneView &scene, const Target &target);

}  // namespace rc::hal
