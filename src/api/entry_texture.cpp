// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: textures. [spec 3.4; G 5]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

constexpr RCsizei kSmallestSide = 16, kLargestSide = 1024, kLargestSideEnabled = 16384;

std::optional<ddk::TextureSlot> slotOf(RCenum target) {
  if (target == RC_TEXTURE_2D) return ddk::kColourMap;
  if (target == RC_TEXTURE_2D_NORMAL) return ddk::kNormalMap;
  return std::nullopt;
}

// The slot, or RC_INVALID_ENUM and nothing.
std::optional<ddk::TextureSlot> checkTarget(Context &context, RCenum target) {
  const auto slot = slotOf(target);
  if (!slot) context.fail(RC_INVALID_ENUM, "target 0x%04X is not RC_TEXTURE_2D or RC_TEXTURE_2D_NORMAL", target);
  return slot;
}

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

bool isSide(RCsizei side, RCsizei largest) {
  return side >= kSmallestSide && side <= largest && (side & (side - 1)) == 0;
}

bool isFormat(RCenum format) { return format == RC_RGB || format == RC_RGBA; }

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
    return context.fail(RC_INVALID_ENUM, "format and internalformat must be RC_RGB or RC_RGBA");
  }
  if (internalFormat != image.format) return context.fail(RC_INVALID_OPERATION, "internalformat differs from format");
  if (!image.pixels) return;
  if (image.level != 0 || image.border != 0) return context.fail(RC_INVALID_VALUE, "level and border must be 0");
  const RCsizei largest = context.state.texture.large ? kLargestSideEnabled : kLargestSide;
  if (!isSide(image.width, largest) || !isSide(image.height, largest)) {
    return context.fail(RC_INVALID_VALUE, "%d x %d: sides must be powers of two from %d to %d", image.width,
                        image.height, kSmallestSide, largest);
  }
  for (const LayoutRow &row : kLayouts) {
    if (row.format != image.format || row.type != image.type) continue;
    const TextureState &state = context.state.texture;
    state.bound[state.last].texture->image =
        ddk::makeImage(row.layout, image.width, image.height, image.pixels, state.alpha, state.generateMipmap);
    return context.touch();
  }
  context.fail(RC_INVALID_ENUM, "type 0x%04X does not go with format 0x%04X", image.type, image.format);
}

bool isWrap(RCenum value) { return value == RC_REPEAT || value == RC_CLAMP_TO_EDGE || value == RC_MIRRORED_REPEAT; }

// A wrap mode goes to the texture, and to the material that is bound if it is an object. [spec 3.4]
void setWrap(Context &context, ddk::TextureSlot slot, RCenum pname, RCenum value) {
  if (!isWrap(value)) return context.fail(RC_INVALID_ENUM, "0x%04X is no wrap mode", value);
  const bool s = pname == RC_TEXTURE_WRAP_S;
  ddk::Texture &texture = *context.state.texture.bound[slot].texture;
  (s ? texture.wrapS : texture.wrapT) = value;
  if (context.state.boundMaterial != 0) {
    ddk::TextureUse &use = context.boundMaterial().textures[slot];
    (s ? use.wrapS : use.wrapT) = value;
  }
  context.touch();
}

void setParameter(Context &context, RCenum target, RCenum pname, RCint value) {
  const auto slot = checkTarget(context, target);
  if (!slot) return;
  ddk::Texture &texture = *context.state.texture.bound[*slot].texture;
  switch (pname) {
    case RC_TEXTURE_WRAP_S:
    case RC_TEXTURE_WRAP_T:
      return setWrap(context, *slot, pname, static_cast<RCenum>(value));
    case RC_TEXTURE_MIN_FILTER:
      texture.minFilter = static_cast<RCenum>(value);
      break;
    case RC_TEXTURE_MAG_FILTER:
      texture.magFilter = static_cast<RCenum>(value);
      break;
    case RC_GENERATE_MIPMAP:
      context.state.texture.generateMipmap = value != 0;
      break;
    case RC_TEXTURE_OPAQUE_ALPHA:
      if (value < 1 || value > 255) return context.fail(RC_INVALID_VALUE, "%d is not in 1 ... 255", value);
      texture.opaqueAlpha = value;
      break;
    default:
      return context.fail(RC_INVALID_ENUM, "0x%04X is no texture parameter", pname);
  }
  context.touch();
}

template <class Value>
void getParameter(Context &context, RCenum target, RCenum pname, Value *params) {
  const auto slot = checkTarget(context, target);
  if (!slot) return;
  const ddk::Texture &texture = *context.state.texture.bound[*slot].texture;
  const ddk::TextureUse &use = context.boundMaterial().textures[*slot];
  RCint value = 0;
  switch (pname) {
    case RC_TEXTURE_WRAP_S:
      value = RCint(use.wrapS.value_or(texture.wrapS));
      break;
    case RC_TEXTURE_WRAP_T:
      value = RCint(use.wrapT.value_or(texture.wrapT));
      break;
    case RC_TEXTURE_MIN_FILTER:
      value = RCint(texture.minFilter);
      break;
    case RC_TEXTURE_MAG_FILTER:
      value = RCint(texture.magFilter);
      break;
    case RC_GENERATE_MIPMAP:
      value = context.state.texture.generateMipmap;
      break;
    case RC_TEXTURE_OPAQUE_ALPHA:
      value = texture.opaqueAlpha;
      break;
    default:
      return context.fail(RC_INVALID_ENUM, "0x%04X is no texture parameter", pname);
  }
  if (params) *params = static_cast<Value>(value);
}

void bind(Context &context, ddk::TextureSlot slot, RCuint name) {
  const std::shared_ptr<ddk::Texture> texture = context.objects().textures.bind(name);
  context.state.texture.bound[slot] = {name, texture};
  context.state.texture.last = slot;
  ddk::TextureUse &use = context.boundMaterial().textures[slot];
  use.name = name;
  use.texture = texture;
  context.touch();
}

}  // namespace

extern "C" {

void rcGenTextures(RCsizei n, RCuint *textures) {
  enter("rcGenTextures", [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d", n);
    for (RCsizei i = 0; textures && i < n; ++i) textures[i] = context.objects().textures.generate();
  });
}

void rcDeleteTextures(RCsizei n, const RCuint *textures) {
  enter("rcDeleteTextures", [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d", n);
    for (RCsizei i = 0; textures && i < n; ++i) {
      if (textures[i] == 0) continue;
      context.objects().textures.remove(textures[i]);
      for (TextureBinding &binding : context.state.texture.bound) {
        if (binding.name == textures[i]) binding = {0, context.objects().textures.bind(0)};
      }
    }
  });
}

void rcBindTexture(RCenum target, RCuint texture) {
  enter("rcBindTexture", [&](Context &context) {
    if (const auto slot = checkTarget(context, target)) bind(context, *slot, texture);
  });
}

RCboolean rcIsTexture(RCuint texture) {
  return enter("rcIsTexture", [&](Context &context) -> RCboolean {
    return context.objects().textures.contains(texture) ? RC_TRUE : RC_FALSE;
  });
}

void rcTexImage2D(RCenum target, RCint level, RCint internalformat, RCsizei width, RCsizei height, RCint border,
                  RCenum format, RCenum type, const RCvoid *pixels) {
  enter("rcTexImage2D", [&](Context &context) {
    texImage(context, {target, level, internalformat, width, height, border, format, type, pixels});
  });
}

void rcTextureAlpha(RCubyte value) {
  enter("rcTextureAlpha", [&](Context &context) { context.state.texture.alpha = value; });
}

void rcTexParameterf(RCenum target, RCenum pname, RCfloat param) {
  enter("rcTexParameterf", [&](Context &context) { setParameter(context, target, pname, roundToInt(param)); });
}

void rcTexParameteri(RCenum target, RCenum pname, RCint param) {
  enter("rcTexParameteri", [&](Context &context) { setParameter(context, target, pname, param); });
}

// Tokens and counts are not scaled: x values are plain integers here, as in GL.
void rcTexParameterx(RCenum target, RCenum pname, RCfixed param) {
  enter("rcTexParameterx", [&](Context &context) { setParameter(context, target, pname, param); });
}

void rcTexParameterfv(RCenum target, RCenum pname, const RCfloat *params) {
  if (params) enter("rcTexParameterfv", [&](Context &c) { setParameter(c, target, pname, roundToInt(*params)); });
}

void rcTexParameteriv(RCenum target, RCenum pname, const RCint *params) {
  if (params) enter("rcTexParameteriv", [&](Context &context) { setParameter(context, target, pname, *params); });
}

void rcTexParameterxv(RCenum target, RCenum pname, const RCfixed *params) {
  if (params) enter("rcTexParameterxv", [&](Context &context) { setParameter(context, target, pname, *params); });
}

void rcGetTexParameterfv(RCenum target, RCenum pname, RCfloat *params) {
  enter("rcGetTexParameterfv", [&](Context &context) { getParameter(context, target, pname, params); });
}

void rcGetTexParameteriv(RCenum target, RCenum pname, RCint *params) {
  enter("rcGetTexParameteriv", [&](Context &context) { getParameter(context, target, pname, params); });
}

void rcGetTexParameterxv(RCenum target, RCenum pname, RCfixed *params) {
  enter("rcGetTexParameterxv", [&](Context &context) { getParameter(context, target, pname, params); });
}

}  // extern "C"
