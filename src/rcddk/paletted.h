// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// paletted.h: images of OES_compressed_paletted_texture, the compressed format of OpenGL ES 1.1. [OpenGL ES 1.1, 3.7.4]
// In: format, bytes.  Out: RGBA8 texels.  Next: rcddk/texture.h
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "RC/rctypes.h"
#include "base/memory.h"

namespace rc::ddk {

struct PalettedFormat {
  RCenum format;   // RC_PALETTE4_RGB8_OES ...
  int entryBytes;  // of a colour in the palette
  int indexBits;   // 4 or 8
  bool hasAlpha;
};

// All formats, in the order of their tokens.
std::span<const PalettedFormat> palettedFormats();

// Null for tokens that are no such format.
const PalettedFormat *findPalettedFormat(RCenum format);

// Bytes of a palette and `levels` mip levels, each half the size of the one before.
size_t palettedBytes(const PalettedFormat &format, int width, int height, int levels);

// Level 0; alpha: what texels without one get. bytes holds at least that level.
Array<uint32_t> readPaletted(const PalettedFormat &format, int width, int height, std::span<const std::byte> bytes,
                             uint8_t alpha);

}  // namespace rc::ddk
