// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/texture.h"

#include <cstring>

namespace rc::ddk {
namespace {

uint32_t pack(uint32_t r, uint32_t g, uint32_t b, uint32_t a) { return r | g << 8 | b << 16 | a << 24; }

// A channel of `bits` bits to 8: the top bits are repeated, so that full stays full.
uint32_t widen(uint32_t value, int bits) {
  const uint32_t top = value << (8 - bits);
  return top | top >> bits;
}

uint32_t readTexel(PixelLayout layout, const uint8_t *at, uint32_t alpha) {
  uint16_t packed = 0;
  switch (layout) {
    case PixelLayout::Rgb8:
      return pack(at[0], at[1], at[2], alpha);
    case PixelLayout::Rgba8:
      return pack(at[0], at[1], at[2], at[3]);
    default:
      std::memcpy(&packed, at, sizeof packed);  // client memory need not be aligned
  }
  const uint32_t p = packed;
  if (layout == PixelLayout::Rgb565) return pack(widen(p >> 11, 5), widen(p >> 5 & 63, 6), widen(p & 31, 5), alpha);
  if (layout == PixelLayout::Rgba4444) {
    return pack((p >> 12) * 17, (p >> 8 & 15) * 17, (p >> 4 & 15) * 17, (p & 15) * 17);
  }
  return pack(widen(p >> 11, 5), widen(p >> 6 & 31, 5), widen(p >> 1 & 31, 5), (p & 1) * 255);
}

size_t texelBytes(PixelLayout layout) { return layout == PixelLayout::Rgb8 ? 3 : layout == PixelLayout::Rgba8 ? 4 : 2; }

// Mean of 2 x 2 texels, channel by channel, rounded.
void halve(const Texels &fine, int width, int height, Texels &coarse) {
  const int halfWidth = std::max(width / 2, 1), halfHeight = std::max(height / 2, 1);
  const auto at = [&](int x, int y) {
    return fine[size_t(std::min(y, height - 1)) * size_t(width) + size_t(std::min(x, width - 1))];
  };
  coarse.clear();
  coarse.reserve(size_t(halfWidth) * size_t(halfHeight));
  for (int y = 0; y < halfHeight; ++y) {
    for (int x = 0; x < halfWidth; ++x) {
      uint32_t mean = 0;
      for (int shift = 0; shift < 32; shift += 8) {
        const auto channel = [&](int dx, int dy) { return at(2 * x + dx, 2 * y + dy) >> shift & 255; };
        mean |= (channel(0, 0) + channel(1, 0) + channel(0, 1) + channel(1, 1) + 2) / 4 << shift;
      }
      coarse.push_back(mean);
    }
  }
}

// All levels after the first, anew; in the memory of the old ones where there are some.
void makeMipLevels(Image &image) {
  int width = image.width, height = image.height;
  for (size_t level = 1; width > 1 || height > 1; ++level) {
    if (level == image.levels.size()) image.levels.emplace_back();
    halve(image.levels[level - 1], width, height, image.levels[level]);
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
  }
}

}  // namespace

Texels readTexels(const PixelSource &source, int width, int height, uint8_t alpha) {
  const size_t texel = texelBytes(source.layout), alignment = size_t(source.alignment);
  const size_t rowBytes = (size_t(width) * texel + alignment - 1) / alignment * alignment;
  Texels texels;
  texels.reserve(size_t(width) * size_t(height));
  for (size_t y = 0; y < size_t(height); ++y) {
    const uint8_t *row = static_cast<const uint8_t *>(source.pixels) + y * rowBytes;
    for (size_t x = 0; x < size_t(width); ++x) texels.push_back(readTexel(source.layout, row + x * texel, alpha));
  }
  return texels;
}

std::shared_ptr<Image> makeImage(Texels base, int width, int height, bool mipmaps) {
  auto image = std::make_shared<Image>();
  image->width = width;
  image->height = height;
  image->levels.push_back(std::move(base));
  if (mipmaps) makeMipLevels(*image);
  return image;
}

void Texture::load(std::shared_ptr<Image> newImage, RCenum newFormat) {
  image = std::move(newImage);
  format = newFormat;
  loan = nullptr;
}

void Texture::replacePart(const hal::PixelRect &part, std::span<const uint32_t> texels) {
  if (image.use_count() > 1) image = std::make_shared<Image>(*image);
  for (int y = 0; y < part.rows; ++y) {
    const auto row = texels.subspan(size_t(y) * size_t(part.columns), size_t(part.columns));
    std::copy(row.begin(), row.end(),
              image->levels[0].begin() + (std::ptrdiff_t{part.row} + y) * image->width + part.column);
  }
  if (image->levels.size() > 1) makeMipLevels(*image);
}

hal::TextureView Texture::view() const {
  hal::TextureView view;
  for (size_t i = 0; i < image->levels.size(); ++i) view.levels[i] = image->levels[i].data();
  view.width = image->width;
  view.height = image->height;
  view.levelCount = static_cast<int>(image->levels.size());
  view.trilinear = minFilter == RC_LINEAR_MIPMAP_LINEAR;
  view.anisotropy = anisotropy;
  view.hasAlpha = format != RC_RGB;
  view.opaqueAlpha = static_cast<float>(opaqueAlpha);
  return view;
}

hal::Wrap wrapOf(RCenum token) {
  return token == RC_CLAMP_TO_EDGE     ? hal::Wrap::ClampToEdge
         : token == RC_MIRRORED_REPEAT ? hal::Wrap::MirroredRepeat
                                       : hal::Wrap::Repeat;
}

}  // namespace rc::ddk
