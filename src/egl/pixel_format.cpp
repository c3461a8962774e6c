// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/pixel_format.h"

#include <X11/Xutil.h>

#include <bit>

namespace rc::egl {
namespace {

// The table that puts an 8-bit channel where a mask wants it: its upper bits, or repeated where there is more room.
std::array<uint32_t, 256> channelTable(unsigned long mask) {
  std::array<uint32_t, 256> table{};
  const auto bits = static_cast<uint32_t>(mask);
  if (!bits) return table;
  const int shift = std::countr_zero(bits), width = std::popcount(bits);
  for (uint32_t i = 0; i < 256; ++i) {
    const uint32_t wide = i << 24 | i << 16 | i << 8 | i;
    table[i] = wide >> (32 - width) << shift;
  }
  return table;
}

constexpr int kHostOrder = std::endian::native == std::endian::little ? LSBFirst : MSBFirst;

template <class Pixel>
void storeRow(const PixelFormat &format, const uint32_t *rgba, int width, char *row) {
  auto *pixels = reinterpret_cast<Pixel *>(row);
  for (int x = 0; x < width; ++x) pixels[x] = static_cast<Pixel>(format.encode(rgba[x]));
}

}  // namespace

PixelFormat::PixelFormat(const ColourMasks &masks, int depth)
    : mChannel{channelTable(masks.red), channelTable(masks.green), channelTable(masks.blue)} {
  const uint32_t colours = static_cast<uint32_t>(masks.red | masks.green | masks.blue);
  if (depth == 32) mOpaque = ~colours;
}

void PixelFormat::store(const hal::Target &picture, XImage &image) const {
  const bool plain = image.byte_order == kHostOrder;
  for (int y = 0; y < picture.height; ++y) {
    const uint32_t *rgba = picture.pixels + size_t(y) * size_t(picture.width);
    char *row = image.data + size_t(y) * size_t(image.bytes_per_line);
    if (plain && image.bits_per_pixel == 32) {
      storeRow<uint32_t>(*this, rgba, picture.width, row);
    } else if (plain && image.bits_per_pixel == 16) {
      storeRow<uint16_t>(*this, rgba, picture.width, row);
    } else {
      for (int x = 0; x < picture.width; ++x) XPutPixel(&image, x, y, encode(rgba[x]));
    }
  }
}

}  // namespace rc::egl
