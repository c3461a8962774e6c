// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/surface_attributes.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "egl/error.h"
#include "egl/surface.h"

namespace rc::egl {
namespace {

constexpr EGLint kPbuffer = EGL_PBUFFER_BIT, kWindow = EGL_WINDOW_BIT, kAll = kPbuffer | kWindow | EGL_PIXMAP_BIT;

using Member = EGLint SurfaceAttributes::*;

// What a list may hold, for which kinds of surface, and the error of a wrong value.
struct CreationRow {
  EGLint name;
  EGLint kinds;
  Member member;
  ValueCheck valid;
  EGLint error;
};
constexpr CreationRow kCreation[] = {
    {EGL_WIDTH, kPbuffer, &SurfaceAttributes::width, countValue, EGL_BAD_PARAMETER},
    {EGL_HEIGHT, kPbuffer, &SurfaceAttributes::height, countValue, EGL_BAD_PARAMETER},
    {EGL_LARGEST_PBUFFER, kPbuffer, &SurfaceAttributes::largestPbuffer, booleanValue, EGL_BAD_ATTRIBUTE},
    {EGL_TEXTURE_FORMAT, kPbuffer, &SurfaceAttributes::textureFormat,
     oneOf<EGL_NO_TEXTURE, EGL_TEXTURE_RGB, EGL_TEXTURE_RGBA>, EGL_BAD_ATTRIBUTE},
    {EGL_TEXTURE_TARGET, kPbuffer, &SurfaceAttributes::textureTarget, oneOf<EGL_NO_TEXTURE, EGL_TEXTURE_2D>,
     EGL_BAD_ATTRIBUTE},
    {EGL_MIPMAP_TEXTURE, kPbuffer, &SurfaceAttributes::mipmapTexture, booleanValue, EGL_BAD_ATTRIBUTE},
    {EGL_RENDER_BUFFER, kWindow, &SurfaceAttributes::renderBuffer, oneOf<EGL_BACK_BUFFER, EGL_SINGLE_BUFFER>,
     EGL_BAD_ATTRIBUTE},
    {EGL_GL_COLORSPACE, kAll, &SurfaceAttributes::glColorspace, oneOf<EGL_GL_COLORSPACE_LINEAR, EGL_GL_COLORSPACE_SRGB>,
     EGL_BAD_ATTRIBUTE},
    {EGL_VG_COLORSPACE, kAll, &SurfaceAttributes::vgColorspace, oneOf<EGL_VG_COLORSPACE_sRGB, EGL_VG_COLORSPACE_LINEAR>,
     EGL_BAD_ATTRIBUTE},
    {EGL_VG_ALPHA_FORMAT, kAll, &SurfaceAttributes::vgAlphaFormat,
     oneOf<EGL_VG_ALPHA_FORMAT_NONPRE, EGL_VG_ALPHA_FORMAT_PRE>, EGL_BAD_ATTRIBUTE},
};

EGLint has(const Config &config, EGLint attribute) { return *config.attribute(attribute, NativeTraits()); }

// A texture of none is as good as one of a power of two.
bool textureSide(EGLint side) { return side == 0 || std::has_single_bit(static_cast<unsigned>(side)); }

void checkTexture(const SurfaceAttributes &wanted, const Config &config) {
  const bool format = wanted.textureFormat != EGL_NO_TEXTURE, target = wanted.textureTarget != EGL_NO_TEXTURE;
  require(format == target, EGL_BAD_MATCH);
  if (!format) return;
  require(has(config, wanted.textureFormat == EGL_TEXTURE_RGB ? EGL_BIND_TO_TEXTURE_RGB : EGL_BIND_TO_TEXTURE_RGBA),
          EGL_BAD_MATCH);
  require(textureSide(wanted.width) && textureSide(wanted.height), EGL_BAD_ATTRIBUTE);
}

// Colours are linear, and nothing is told to OpenVG.
void checkColours(const SurfaceAttributes &wanted, const Config &config) {
  const EGLint types = has(config, EGL_SURFACE_TYPE);
  require(wanted.glColorspace == EGL_GL_COLORSPACE_LINEAR, EGL_BAD_MATCH);
  require(wanted.vgColorspace == EGL_VG_COLORSPACE_sRGB || types & EGL_VG_COLORSPACE_LINEAR_BIT, EGL_BAD_MATCH);
  require(wanted.vgAlphaFormat == EGL_VG_ALPHA_FORMAT_NONPRE || types & EGL_VG_ALPHA_FORMAT_PRE_BIT, EGL_BAD_MATCH);
}

// What eglQuerySurface answers; for other kinds of surface it leaves the value alone.
struct QueryRow {
  EGLint name;
  EGLint kinds;
  EGLint (*value)(const Surface &surface);
};

template <Member Attribute>
EGLint attribute(const Surface &surface) {
  return surface.attributes.*Attribute;
}

template <EGLint Value>
EGLint constant(const Surface &) {
  return Value;
}

constexpr QueryRow kQueries[] = {
    {EGL_CONFIG_ID, kAll, [](const Surface &surface) { return surface.config().id; }},
    {EGL_WIDTH, kAll, [](const Surface &surface) -> EGLint { return surface.size().width; }},
    {EGL_HEIGHT, kAll, [](const Surface &surface) -> EGLint { return surface.size().height; }},
    {EGL_LARGEST_PBUFFER, kPbuffer, attribute<&SurfaceAttributes::largestPbuffer>},
    {EGL_TEXTURE_FORMAT, kPbuffer, attribute<&SurfaceAttributes::textureFormat>},
    {EGL_TEXTURE_TARGET, kPbuffer, attribute<&SurfaceAttributes::textureTarget>},
    {EGL_MIPMAP_TEXTURE, kPbuffer, attribute<&SurfaceAttributes::mipmapTexture>},
    {EGL_MIPMAP_LEVEL, kPbuffer, attribute<&SurfaceAttributes::mipmapLevel>},
    {EGL_RENDER_BUFFER, kAll, attribute<&SurfaceAttributes::renderBuffer>},
    {EGL_SWAP_BEHAVIOR, kAll, attribute<&SurfaceAttributes::swapBehavior>},
    {EGL_MULTISAMPLE_RESOLVE, kAll, attribute<&SurfaceAttributes::multisampleResolve>},
    {EGL_GL_COLORSPACE, kAll, attribute<&SurfaceAttributes::glColorspace>},
    {EGL_VG_COLORSPACE, kAll, attribute<&SurfaceAttributes::vgColorspace>},
    {EGL_VG_ALPHA_FORMAT, kAll, attribute<&SurfaceAttributes::vgAlphaFormat>},
    {EGL_HORIZONTAL_RESOLUTION, kAll, constant<EGL_UNKNOWN>},
    {EGL_VERTICAL_RESOLUTION, kAll, constant<EGL_UNKNOWN>},
    {EGL_PIXEL_ASPECT_RATIO, kAll, constant<EGL_UNKNOWN>},
};

// What eglSurfaceAttrib changes; some values need a bit of the config's surface type.
struct ChangeRow {
  EGLint name;
  Member member;
  ValueCheck valid;
  EGLint special, specialBit;
};
constexpr ChangeRow kChanges[] = {
    {EGL_MIPMAP_LEVEL, &SurfaceAttributes::mipmapLevel, anyValue, EGL_DONT_CARE, 0},
    {EGL_MULTISAMPLE_RESOLVE, &SurfaceAttributes::multisampleResolve,
     oneOf<EGL_MULTISAMPLE_RESOLVE_DEFAULT, EGL_MULTISAMPLE_RESOLVE_BOX>, EGL_MULTISAMPLE_RESOLVE_BOX,
     EGL_MULTISAMPLE_RESOLVE_BOX_BIT},
    {EGL_SWAP_BEHAVIOR, &SurfaceAttributes::swapBehavior, oneOf<EGL_BUFFER_PRESERVED, EGL_BUFFER_DESTROYED>,
     EGL_BUFFER_PRESERVED, EGL_SWAP_BEHAVIOR_PRESERVED_BIT},
};

// The row of a name; throws for names that have none.
template <class Rows>
const auto &rowOf(const Rows &rows, EGLAttrib name) {
  const auto found = std::find_if(std::begin(rows), std::end(rows), [&](const auto &row) { return row.name == name; });
  require(found != std::end(rows), EGL_BAD_ATTRIBUTE);
  return *found;
}

}  // namespace

SurfaceAttributes readSurfaceAttributes(EGLint kind, const Config &config, Attributes list) {
  SurfaceAttributes wanted;
  if (kind == EGL_PIXMAP_BIT) wanted.renderBuffer = EGL_SINGLE_BUFFER;
  for (; list.more(); list.advance()) {
    const CreationRow &row = rowOf(kCreation, list.name());
    require(row.kinds & kind, EGL_BAD_ATTRIBUTE);
    require(row.valid(list.number()), row.error);
    wanted.*row.member = list.number();
  }
  checkTexture(wanted, config);
  checkColours(wanted, config);
  return wanted;
}

void setSurfaceAttribute(Surface &surface, EGLint name, EGLint value) {
  const ChangeRow &row = rowOf(kChanges, name);
  require(row.valid(value), EGL_BAD_PARAMETER);
  const bool needsBit = row.specialBit != 0 && value == row.special;
  require(!needsBit || has(surface.config(), EGL_SURFACE_TYPE) & row.specialBit, EGL_BAD_MATCH);
  surface.attributes.*row.member = value;
}

std::optional<EGLint> surfaceAttribute(const Surface &surface, EGLint name) {
  const QueryRow &row = rowOf(kQueries, name);
  return row.kinds & surface.kind() ? std::optional(row.value(surface)) : std::nullopt;
}

}  // namespace rc::egl
