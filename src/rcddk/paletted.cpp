// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/paletted.h"

#include <algorithm>

#include "rcddk/texture.h"

namespace rc::ddk {
namespace {

struct Row {
  PalettedFormat format;
  PixelLayout layout;  // of the palette's colours
};

constexpr Row kRows[] = {
    {{RC_PALETTE4_RGB8_OES, 3, 4, false}, PixelLayout::Rgb8},
    {{RC_PALETTE4_RGBA8_OES, 4, 4, true}, PixelLayout::Rgba8},
    {{RC_PALETTE4_R5_G6_B5_OES, 2, 4, false}, PixelLayout::Rgb565},
    {{RC_PALETTE4_RGBA4_OES, 2, 4, true}, PixelLayout::Rgba4444},
    {{RC_PALETTE4_RGB5_A1_OES, 2, 4, true}, PixelLayout::Rgba5551},
    {{RC_PALETTE8_RGB8_OES, 3, 8, false}, PixelLayout::Rgb8},
    {{RC_PALETTE8_RGBA8_OES, 4, 8, true}, PixelLayout::Rgba8},
    {{RC_PALETTE8_R5_G6_B5_OES, 2, 8, false}, PixelLayout::Rgb565},
    {{RC_PALETTE8_RGBA4_OES, 2, 8, true}, PixelLayout::Rgba4444},
    {{RC_PALETTE8_RGB5_A1_OES, 2, 8, true}, PixelLayout::Rgba5551},
};

constexpr auto kFormats = [] {
  std::array<PalettedFormat, std::size(kRows)> formats{};
  for (size_t i = 0; i < formats.size(); ++i) formats[i] = kRows[i].format;
  return formats;
}();

int paletteEntries(const PalettedFormat &format) { return 1 << format.indexBits; }

// Indices of a level lie close together: two in a byte, the first in its upper half.
size_t indexBytes(const PalettedFormat &format, int width, int height) {
  return (size_t(width) * size_t(height) * size_t(format.indexBits) + 7) / 8;
}

}  // namespace

std::span<const PalettedFormat> palettedFormats() { return kFormats; }

const PalettedFormat *findPalettedFormat(RCenum format) {
  const auto *found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const PalettedFormat &row) { return row.format == format; });
  return found == kFormats.end() ? nullptr : found;
}

size_t palettedBytes(const PalettedFormat &format, int width, int height, int levels) {
  size_t bytes = size_t(paletteEntries(format)) * size_t(format.entryBytes);
  for (int level = 0; level < levels; ++level) {
    bytes += indexBytes(format, std::max(width >> level, 1), std::max(height >> level, 1));
  }
  return bytes;
}

Texels readPaletted(const PalettedFormat &format, int width, int height, std::span<const std::byte> bytes,
                    uint8_t alpha) {
  const PixelLayout layout = kRows[size_t(&format - kFormats.data())].layout;
  const int entries = paletteEntries(format);
  const Texels palette = readTexels({layout, bytes.data()}, entries, 1, alpha);
  const auto indices = bytes.subspan(size_t(entries) * size_t(format.entryBytes));
  Texels texels(size_t(width) * size_t(height));
  for (size_t i = 0; i < texels.size(); ++i) {
    const auto byte = static_cast<uint8_t>(indices[format.indexBits == 8 ? i : i / 2]);
    const int index = format.indexBits == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15;
    texels[i] = palette[size_t(index)];
  }
  return texels;
}

}  // namespace rc::ddk
