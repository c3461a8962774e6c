// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture.h: a texture object: any accepted format becomes RGBA8 with all mip levels. [spec 3.4; G 5]
#pragma once

#include <memory>
#include <vector>

#include "RC/rctokens.h"
#include "RC/rctypes.h"
#include "base/memory.h"
#include "rchal/scene_view.h"

namespace rc::ddk {

// How client memory is laid out. [reference 4.5]
enum class PixelLayout { Rgb8, Rgba8, Rgb565, Rgba4444, Rgba5551 };

// RGBA8, R in the low byte.
using Texels = Array<uint32_t>;

struct Image {
  std::vector<Texels> levels;  // level 0 first, rows from v = 0
  int width = 0, height = 0;   // of level 0
};

// Texels in client memory, the lowest row first; a row begins at a multiple of `alignment` bytes from the first one.
struct PixelSource {
  PixelLayout layout;
  const void *pixels;
  int alignment = 1;
};

// As RGBA8; alpha: what texels without one get.
Texels readTexels(const PixelSource &source, int width, int height, uint8_t alpha);

// base: width * height texels. width, height: powers of two.
std::shared_ptr<Image> makeImage(Texels base, int width, int height, bool mipmaps);

// Samples side by side where a footprint is stretched, at most.
inline constexpr int kMostAnisotropy = 16;

struct Texture {
  std::shared_ptr<Image> image;      // null where nothing was loaded; a frame on its way may share it
  std::shared_ptr<const void> loan;  // held for an image that somebody lent; let go when it is replaced
  RCenum wrapS = RC_REPEAT, wrapT = RC_REPEAT;
  RCenum minFilter = RC_NEAREST_MIPMAP_LINEAR, magFilter = RC_LINEAR;  // GL's initial values
  int opaqueAlpha = 16;
  int anisotropy = 1;
  RCenum format = 0;  // RC_RGB or RC_RGBA, as loaded

  bool loaded() const { return image != nullptr; }
  void load(std::shared_ptr<Image> newImage, RCenum newFormat);
  // Replaces a rectangle of level 0 by its texels, and the mip levels, if there are some, by new ones; in a copy of the
  // image if a frame is on its way that shows it.
  void replacePart(const hal::PixelRect &part, std::span<const uint32_t> texels);
  // Of a texture that is loaded.
  hal::TextureView view() const;
};

hal::Wrap wrapOf(RCenum token);

}  // namespace rc::ddk
