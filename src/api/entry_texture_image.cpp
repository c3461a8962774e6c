// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: images of textures, from memory, from paletted data and from the picture. [spec 3.4; G 5;
// reference 4.5] Images go to the texture that was bound last, whichever target it was bound to.
#include "RC/rc.h"
#include "api/guard.h"
#include "api/picture.h"
#include "api/texture_target.h"
#include "rcddk/paletted.h"

using namespace rc;
using namespace rc::api;

namespace {

constexpr RCsizei kSmallestSide = 16, kLargestSide = 1024, kLargestSideEnabled = 16384;

struct LayoutRow {
  RCenum format, type;
  ddk::PixelLayout layout;
};
constexpr LayoutRow kLayouts[] = {
    {RC_RGB, RC_BYTE, ddk::PixelLayout::Rgb8},
    {RC_RGB, RC_UNSIGNED_BYTE, ddk::PixelLayout::Rgb8},
    {RC_RGB, RC_SHORT, ddk::PixelLayout::Rgb565},
    {RC_RGB, RC_UNSIGNED_SHORT, ddk::PixelLayout::Rgb565},
    {RC_RGB, RC_UNSIGNED_SHORT_5_6_5, ddk::PixelLayout::Rgb565},
    {RC_RGBA, RC_BYTE, ddk::PixelLayout::Rgba8},
    {RC_RGBA, RC_UNSIGNED_BYTE, ddk::PixelLayout::Rgba8},
    {RC_RGBA, RC_UNSIGNED_SHORT_4_4_4_4, ddk::PixelLayout::Rgba4444},
    {RC_RGBA, RC_UNSIGNED_SHORT_5_5_5_1, ddk::PixelLayout::Rgba5551},
};

bool isFormat(RCenum format) { return format == RC_RGB || format == RC_RGBA; }

// The layout, or RC_INVALID_ENUM and null.
const LayoutRow *findLayout(Context &context, RCenum format, RCenum type) {
  for (const LayoutRow &row : kLayouts) {
    if (row.format == format && row.type == type) return &row;
  }
  context.fail(RC_INVALID_ENUM, "type 0x%04X does not go with format 0x%04X", type, format);
  return nullptr;
}

bool checkSize(Context &context, RCsizei width, RCsizei height) {
  const RCsizei largest = context.state.texture.large ? kLargestSideEnabled : kLargestSide;
  const auto isSide = [&](RCsizei side) {
    return side >= kSmallestSide && side <= largest && (side & (side - 1)) == 0;
  };
  if (isSide(width) && isSide(height)) return true;
  context.fail(RC_INVALID_VALUE, "width x height is %d x %d, not powers of two from %d to %d", width, height,
               kSmallestSide, largest);
  return false;
}

bool checkLevel(Context &context, RCint level, RCint border) {
  if (level == 0 && border == 0) return true;
  context.fail(RC_INVALID_VALUE, "level is %d and border %d, not 0", level, border);
  return false;
}

ddk::Texture &currentTexture(Context &context) {
  const TextureState &state = context.state.texture;
  return *state.bound[state.last].texture;
}

void load(Context &context, ddk::Texels texels, RCsizei width, RCsizei height, RCenum format) {
  const bool mipmaps = context.state.texture.generateMipmap;
  currentTexture(context).load(ddk::makeImage(std::move(texels), width, height, mipmaps), format);
  context.touch();
}

struct TexImage {
  RCenum target;
  RCint level, internalformat;
  RCsizei width, height;
  RCint border;
  RCenum format, type;
  const RCvoid *pixels;
};

// Checks in the original's order, then loads. [reference 4.5]
void texImage(Context &context, const TexImage &image) {
  if (!checkTarget(context, image.target)) return;
  const auto internalFormat = static_cast<RCenum>(image.internalformat);
  if (!isFormat(image.format) || !isFormat(internalFormat)) {
    return context.fail(RC_INVALID_ENUM, "internalformat 0x%04X and format 0x%04X are not both RC_RGB or RC_RGBA",
                        internalFormat, image.format);
  }
  if (internalFormat != image.format)
    return context.fail(RC_INVALID_OPERATION, "internalformat 0x%04X is not format 0x%04X", internalFormat,
                        image.format);
  if (!image.pixels) return;
  if (!checkLevel(context, image.level, image.border) || !checkSize(context, image.width, image.height)) return;
  const LayoutRow *layout = findLayout(context, image.format, image.type);
  if (!layout) return;
  const ddk::PixelSource source{layout->layout, image.pixels, context.state.pixelStore.unpackAlignment};
  load(context, ddk::readTexels(source, image.width, image.height, context.state.texture.alpha), image.width,
       image.height, image.format);
}

// Whether a part of the current texture can be replaced.
bool checkPart(Context &context, RCint level, const hal::PixelRect &part) {
  const ddk::Texture &texture = currentTexture(context);
  if (!checkLevel(context, level, 0)) return false;
  if (!texture.loaded()) {
    context.fail(RC_INVALID_OPERATION, "the texture has no image yet");
    return false;
  }
  const ddk::Image &image = *texture.image;
  const bool inside = part.column >= 0 && part.row >= 0 && part.columns >= 0 && part.rows >= 0 &&
                      part.columns <= image.width && part.column <= image.width - part.columns &&
                      part.rows <= image.height && part.row <= image.height - part.rows;
  if (!inside) {
    context.fail(RC_INVALID_VALUE, "width x height is %d x %d at xoffset %d, yoffset %d: not within the %d x %d texels",
                 part.columns, part.rows, part.column, part.row, image.width, image.height);
  }
  return inside;
}

void replacePart(Context &context, const hal::PixelRect &part, const ddk::Texels &texels) {
  if (texels.empty()) return;
  currentTexture(context).replacePart(part, texels);
  context.touch();
}

void texSubImage(Context &context, RCint level, const hal::PixelRect &part, RCenum format, RCenum type,
                 const RCvoid *pixels) {
  if (!isFormat(format)) return context.fail(RC_INVALID_ENUM, "format 0x%04X is not RC_RGB or RC_RGBA", format);
  const LayoutRow *layout = findLayout(context, format, type);
  if (!layout || !checkPart(context, level, part)) return;
  if (format != currentTexture(context).format) {
    return context.fail(RC_INVALID_OPERATION, "format 0x%04X is not 0x%04X, in which the texture was loaded", format,
                        currentTexture(context).format);
  }
  if (!pixels) return;
  const ddk::PixelSource source{layout->layout, pixels, context.state.pixelStore.unpackAlignment};
  replacePart(context, part, ddk::readTexels(source, part.columns, part.rows, context.state.texture.alpha));
}

// Texels out of the picture, transparent black beside it; nothing, and an error, where there is no surface.
std::optional<ddk::Texels> copyPicture(Context &context, RCint x, RCint y, const hal::PixelRect &part, RCenum format) {
  const hal::Target picture = context.picture();
  if (!picture.pixels) {
    context.fail(RC_INVALID_OPERATION, "there is no surface to copy from");
    return std::nullopt;
  }
  const uint32_t alpha = uint32_t{context.state.texture.alpha} << 24;
  ddk::Texels texels(size_t(part.columns) * size_t(part.rows));
  for (size_t i = 0; i < texels.size(); ++i) {
    const auto column = int64_t(i % size_t(part.columns)), row = int64_t(i / size_t(part.columns));
    const uint32_t *pixel = pictureAt(picture, x + column, y + row);
    if (pixel) texels[i] = format == RC_RGB ? (*pixel & 0x00ffffff) | alpha : *pixel;
  }
  return texels;
}

// Paletted data: level says how many mip levels come along, which are made anew here. [OpenGL ES 1.1, 3.7.4]
void compressedTexImage(Context &context, RCint level, RCenum format, RCsizei width, RCsizei height, RCint border,
                        RCsizei imageSize, const RCvoid *data) {
  const ddk::PalettedFormat *paletted = ddk::findPalettedFormat(format);
  if (!paletted)
    return context.fail(RC_INVALID_ENUM,
                        "internalformat 0x%04X is not one of RC_PALETTE4_RGB8_OES ... RC_PALETTE8_RGB5_A1_OES", format);
  if (level > 0 || level <= -hal::kMaxTextureLevels || border != 0) {
    return context.fail(RC_INVALID_VALUE, "level is %d, not 0 or minus the number of further levels; border is %d",
                        level, border);
  }
  if (!checkSize(context, width, height)) return;
  const size_t bytes = ddk::palettedBytes(*paletted, width, height, 1 - level);
  if (imageSize < 0 || size_t(imageSize) != bytes) {
    return context.fail(RC_INVALID_VALUE, "imageSize is %d; this image has %zu bytes", imageSize, bytes);
  }
  if (!data) return;
  const std::span given(static_cast<const std::byte *>(data), bytes);
  load(context, ddk::readPaletted(*paletted, width, height, given, context.state.texture.alpha), width, height,
       paletted->hasAlpha ? RC_RGBA : RC_RGB);
}

}  // namespace

extern "C" {

void rcTexImage2D(RCenum target, RCint level, RCint internalformat, RCsizei width, RCsizei height, RCint border,
                  RCenum format, RCenum type, const RCvoid *pixels) {
  enter(Call("rcTexImage2D", target, level, internalformat, width, height, border, format, type, pixels),
        [&](Context &context) {
          texImage(context, {target, level, internalformat, width, height, border, format, type, pixels});
        });
}

void rcTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset, RCsizei width, RCsizei height,
                     RCenum format, RCenum type, const RCvoid *pixels) {
  enter(Call("rcTexSubImage2D", target, level, xoffset, yoffset, width, height, format, type, pixels),
        [&](Context &context) {
          if (!checkTarget(context, target)) return;
          texSubImage(context, level, {xoffset, yoffset, width, height}, format, type, pixels);
        });
}

void rcCopyTexImage2D(RCenum target, RCint level, RCenum internalformat, RCint x, RCint y, RCsizei width,
                      RCsizei height, RCint border) {
  enter(Call("rcCopyTexImage2D", target, level, internalformat, x, y, width, height, border), [&](Context &context) {
    if (!checkTarget(context, target)) return;
    if (!isFormat(internalformat))
      return context.fail(RC_INVALID_ENUM, "internalformat 0x%04X is not RC_RGB or RC_RGBA", internalformat);
    if (!checkLevel(context, level, border) || !checkSize(context, width, height)) return;
    auto texels = copyPicture(context, x, y, {0, 0, width, height}, internalformat);
    if (texels) load(context, std::move(*texels), width, height, internalformat);
  });
}

void rcCopyTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset, RCint x, RCint y, RCsizei width,
                         RCsizei height) {
  enter(Call("rcCopyTexSubImage2D", target, level, xoffset, yoffset, x, y, width, height), [&](Context &context) {
    const hal::PixelRect part{xoffset, yoffset, width, height};
    if (!checkTarget(context, target) || !checkPart(context, level, part)) return;
    const auto texels = copyPicture(context, x, y, part, currentTexture(context).format);
    if (texels) replacePart(context, part, *texels);
  });
}

void rcCompressedTexImage2D(RCenum target, RCint level, RCenum internalformat, RCsizei width, RCsizei height,
                            RCint border, RCsizei imageSize, const RCvoid *data) {
  enter(Call("rcCompressedTexImage2D", target, level, internalformat, width, height, border, imageSize, data),
        [&](Context &context) {
          if (!checkTarget(context, target)) return;
          compressedTexImage(context, level, internalformat, width, height, border, imageSize, data);
        });
}

// OpenGL ES 1.1 has no format that can be changed in part.
void rcCompressedTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset, RCsizei width, RCsizei height,
                               RCenum format, RCsizei imageSize, const RCvoid *data) {
  enter(Call("rcCompressedTexSubImage2D", target, level, xoffset, yoffset, width, height, format, imageSize, data),
        [&](Context &context) {
          if (!checkTarget(context, target)) return;
          const bool known = ddk::findPalettedFormat(format) != nullptr;
          context.fail(known ? RC_INVALID_OPERATION : RC_INVALID_ENUM,
                       "format 0x%04X: paletted images cannot be changed in part", format);
        });
}

void rcTextureAlpha(RCubyte value) {
  enter(Call("rcTextureAlpha", value), [&](Context &context) { context.state.texture.alpha = value; });
}

}  // extern "C"
