// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture.h: a texture object: any accepted format becomes RGBA8 with all mip levels. [spec 3.4; G 5]
#pragma once

#include <vector>

#include "RC/rctokens.h"
#include "RC/rctypes.h"
#include "rchal/scene_view.h"

namespace rc::ddk {

// How client memory is laid out. [reference 4.5]
enum class PixelLayout { Rgb8, Rgba8, Rgb565, Rgba4444, Rgba5551 };

struct Image {
  std::vector<std::vector<uint32_t>> levels;  // RGBA8, R in the low byte; level 0 first, rows from v = 0
  int width = 0, height = 0;                  // of level 0; 0 where nothing was loaded
};

// pixels: width * height tight texels; alpha: what texels without one get. width, height: powers of two.
Image makeImage(PixelLayout layout, int width, int height, const void *pixels, uint8_t alpha, bool mipmaps);

struct Texture {
  Image image;
  RCenum wrapS = RC_REPEAT, wrapT = RC_REPEAT;
  RCenum minFilter = RC_NEAREST_MIPMAP_LINEAR, magFilter = RC_LINEAR;  // GL's initial values
  int opaqueAlpha = 16;

  bool loaded() const { return image.width > 0; }
  hal::TextureView view() const;
};

hal::Wrap wrapOf(RCenum token);

}  // namespace rc::ddk
