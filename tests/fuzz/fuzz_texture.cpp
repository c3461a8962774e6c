// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Images of every format, size and alignment, in memory of exactly the size that the call may read or write; parts,
// copies, paletted data, mip levels, and pictures with all of them.
#include "context_session.h"
#include "image_memory.h"
#include "rcddk/paletted.h"

namespace rc::fuzz {
namespace {

constexpr RCenum kFormats[] = {RC_RGB, RC_RGBA, RC_ALPHA, RC_LUMINANCE};
constexpr RCenum kTypes[] = {RC_UNSIGNED_BYTE,          RC_BYTE,  RC_UNSIGNED_SHORT_5_6_5, RC_UNSIGNED_SHORT_4_4_4_4,
                             RC_UNSIGNED_SHORT_5_5_5_1, RC_SHORT, RC_UNSIGNED_SHORT,       RC_FLOAT};
constexpr RCenum kTargets[] = {RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL};
constexpr RCsizei kSides[] = {16, 32, 64, 16, 32, 128, 8, 16};

struct Texture {
  Input &in;
  ContextSession session{settingsOf(in.byte())};
  RCint unpack = 1, pack = 4;  // alignments

  RCenum target() { return in.below(16) == 0 ? in.token() : in.oneOf(kTargets); }
  RCenum format() { return in.below(16) == 0 ? in.token() : kFormats[in.below(3) == 2 ? in.below(4) : in.below(2)]; }
  RCenum type() { return in.below(16) == 0 ? in.token() : kTypes[in.below(4) < 2 ? 0 : in.below(8)]; }
  RCsizei side() { return in.below(8) == 0 ? in.integer() : in.oneOf(kSides); }
  RCint level() { return in.below(8) == 0 ? in.integer() : 0; }
};

void loadImage(Texture &t) {
  const RCenum target = t.target(), format = t.format(), type = t.type();
  const RCint internal = RCint(t.in.below(8) == 0 ? t.format() : format), level = t.level();
  const RCsizei width = t.side(), height = t.side();
  const RCint border = t.in.below(16) == 0 ? t.in.integer() : 0;
  Pixels pixels(imageBytes(width, height, texelBytes(format, type), t.unpack), t.in);
  rcTexImage2D(target, level, internal, width, height, border, format, type, pixels.data());
}

void loadPart(Texture &t) {
  const RCenum target = t.target(), format = t.format(), type = t.type();
  const RCint level = t.level(), x = t.in.integer(), y = t.in.integer();
  const RCsizei width = t.in.below(3) ? t.in.integer() : t.side(), height = t.in.below(3) ? t.in.integer() : t.side();
  Pixels pixels(imageBytes(width, height, texelBytes(format, type), t.unpack), t.in);
  rcTexSubImage2D(target, level, x, y, width, height, format, type, pixels.data());
}

void loadPaletted(Texture &t) {
  const RCenum target = t.target(), format = RC_PALETTE4_RGB8_OES + RCenum(t.in.below(11));
  const RCint level = t.in.below(2) ? 0 : t.in.below(2) ? -RCint(t.in.below(16)) : t.in.integer();
  const RCsizei width = t.side(), height = t.side();
  const RCint border = t.level();
  const ddk::PalettedFormat *row = ddk::findPalettedFormat(format);
  const bool sound = row && width > 0 && height > 0 && level <= 0 && level > -16;
  const uint64_t bytes = sound ? ddk::palettedBytes(*row, width, height, 1 - level) : 0;
  const RCsizei size = t.in.below(8) == 0 ? t.in.integer() : RCsizei(std::min<uint64_t>(bytes, INT_MAX));
  Pixels pixels(size < 0 ? 0 : uint64_t(size), t.in);
  rcCompressedTexImage2D(target, level, format, width, height, border, size, pixels.data());
  if (t.in.below(8)) return;
  rcCompressedTexSubImage2D(target, level, 0, 0, width, height, format, size, pixels.data());
}

void copyPicture(Texture &t) {
  const RCenum target = t.target(), format = t.format();
  const RCint level = t.level(), x = t.in.integer(), y = t.in.integer();
  const RCsizei width = t.side(), height = t.side();
  rcCopyTexImage2D(target, level, format, x, y, width, height, t.level());
}

void copyPart(Texture &t) {
  const RCenum target = t.target();
  const RCint level = t.level(), toX = t.in.integer(), toY = t.in.integer(), x = t.in.integer(), y = t.in.integer();
  const RCsizei width = t.in.integer(), height = t.in.integer();
  rcCopyTexSubImage2D(target, level, toX, toY, x, y, width, height);
}

void setParameter(Texture &t) {
  constexpr RCenum kNames[] = {
      RC_TEXTURE_WRAP_S,  RC_TEXTURE_WRAP_T,       RC_TEXTURE_MIN_FILTER,        RC_TEXTURE_MAG_FILTER,
      RC_GENERATE_MIPMAP, RC_TEXTURE_OPAQUE_ALPHA, RC_TEXTURE_MAX_ANISOTROPY_EXT};
  constexpr RCenum kValues[] = {RC_REPEAT, RC_CLAMP_TO_EDGE, RC_MIRRORED_REPEAT,      RC_NEAREST,
                                RC_LINEAR, RC_TRUE,          RC_LINEAR_MIPMAP_LINEAR, RC_FALSE};
  const RCenum target = t.target(), name = t.in.below(16) == 0 ? t.in.token() : t.in.oneOf(kNames);
  if (t.in.below(8) == 0) return rcTexParameterf(target, name, t.in.number());
  rcTexParameteri(target, name, t.in.below(4) == 0 ? t.in.integer() : RCint(t.in.oneOf(kValues)));
}

void setEnvironment(Texture &t) {
  constexpr RCenum kModes[] = {RC_REPLACE, RC_MODULATE, RC_DECAL, RC_BLEND, RC_ADD, RC_COMBINE};
  rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, RCint(t.in.oneOf(kModes)));
  const RCfloat color[] = {t.in.number(), t.in.number(), t.in.number(), t.in.number()};
  rcTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, color);
}

void setAlignment(Texture &t) {
  const bool pack = t.in.flag();
  const RCint value = t.in.below(8) == 0 ? t.in.integer() : 1 << t.in.below(4);
  rcPixelStorei(pack ? RC_PACK_ALIGNMENT : RC_UNPACK_ALIGNMENT, value);
  rcGetIntegerv(RC_PACK_ALIGNMENT, &t.pack);
  rcGetIntegerv(RC_UNPACK_ALIGNMENT, &t.unpack);
}

void setSwitches(Texture &t) {
  constexpr RCenum kCaps[] = {
      RC_TEXTURE_2D,       RC_TEXTURE_2D_NORMAL, RC_LARGE_TEXTURES, RC_ALPHA_TEST,  RC_USE_TEXTURE_ALPHA_SHADOW,
      RC_USE_TEXTURE_ONLY, RC_LIGHTING,          RC_LIGHT0,         RC_SCISSOR_TEST};
  (t.in.below(4) ? rcEnable : rcDisable)(t.in.oneOf(kCaps));
  rcTextureAlpha(t.in.byte());
  rcHint(RC_MIPMAP_HINT, t.in.flag() ? RC_NICEST : RC_DONT_CARE);
}

void bind(Texture &t) {
  const RCenum target = t.target();
  rcBindTexture(target, t.in.below(8) == 0 ? t.in.token() : RCuint(t.in.below(4)));
  if (t.in.flag()) rcBindMaterial(RCuint(t.in.below(3)));
  if (t.in.below(8)) return;
  const RCuint name = RCuint(t.in.below(4));
  rcDeleteTextures(1, &name);
}

// Corners of any texture coordinates, with or without a modelview of their own.
void draw(Texture &t) {
  const float corners[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
  float coordinates[8];
  for (float &coordinate : coordinates) coordinate = t.in.number();
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, corners);
  rcTexCoordPointer(2, RC_FLOAT, 0, coordinates);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcDisableClientState(RC_VERTEX_ARRAY);
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
}

void readPixels(Texture &t) {
  const RCint x = t.in.integer(), y = t.in.integer();
  const RCsizei width = t.in.integer(), height = t.in.integer();
  const RCenum format = t.format(), type = t.type();
  const uint64_t bytes = imageBytes(width, height, texelBytes(format, RC_UNSIGNED_BYTE), t.pack);
  Pixels pixels(bytes > Pixels::kMost ? 0 : bytes, t.in);
  rcReadPixels(x, y, width, height, format, type, bytes > Pixels::kMost ? nullptr : pixels.data());
}

void trace(Texture &t) { t.in.flag() ? rcFinish() : t.session.showFrame(); }

constexpr void (*kActions[])(Texture &) = {
    loadImage,   loadPart, loadPaletted, copyPicture, copyPart, setParameter, setEnvironment, setAlignment,
    setSwitches, bind,     draw,         readPixels,  trace,    loadImage,    draw,           loadPart};

}  // namespace

void run(Input in) {
  Texture texture{in};
  rcuPerspective(60, 1.25f, 1, 100);
  rcuLookAt(0, 0, 2, 0, 0, 0, 0, 1, 0);
  rcEnable(RC_TEXTURE_2D);
  for (int actions = 0; actions < 24 && !in.empty(); ++actions) in.oneOf(kActions)(texture);
  texture.session.showFrame();
}

}  // namespace rc::fuzz
