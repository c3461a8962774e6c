// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/config.h"

#include <algorithm>
#include <array>

namespace rc::egl {
namespace {

constexpr std::array<std::array<EGLint, 4>, 3> kColours = {{{5, 6, 5, 0}, {8, 8, 8, 0}, {8, 8, 8, 8}}};
constexpr std::array<EGLint, 4> kSamples = {0, 4, 8, 16};
constexpr std::array<EGLint, 3> kDepths = {0, 16, 24};

// Every combination, in the order in which they come when no colour is asked for.
constexpr auto kConfigs = [] {
  std::array<Config, kColours.size() * kSamples.size() * kDepths.size()> all{};
  EGLint id = 0;
  for (const auto &[red, green, blue, alpha] : kColours) {
    for (const EGLint samples : kSamples) {
      for (const EGLint depth : kDepths) {
        all[size_t(id)] = {id + 1, red, green, blue, alpha, depth, samples};
        ++id;
      }
    }
  }
  return all;
}();

template <EGLint Value>
EGLint constant(const Config &, const NativeTraits &) {
  return Value;
}

template <EGLint Config::*Member>
EGLint member(const Config &config, const NativeTraits &) {
  return config.*Member;
}

// Swaps preserve the picture, and several samples of a pixel count the same.
EGLint surfaceTypes(const Config &config, const NativeTraits &native) {
  return native.surfaceTypes | EGL_SWAP_BEHAVIOR_PRESERVED_BIT |
         (config.samples > 0 ? EGL_MULTISAMPLE_RESOLVE_BOX_BIT : 0);
}

constexpr EGLint kSurfaceBits = EGL_PBUFFER_BIT | EGL_PIXMAP_BIT | EGL_WINDOW_BIT | EGL_VG_COLORSPACE_LINEAR_BIT |
                                EGL_VG_ALPHA_FORMAT_PRE_BIT | EGL_MULTISAMPLE_RESOLVE_BOX_BIT |
                                EGL_SWAP_BEHAVIOR_PRESERVED_BIT;
constexpr EGLint kApiBits =
    EGL_OPENGL_ES_BIT | EGL_OPENVG_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_BIT | EGL_OPENGL_ES3_BIT;
constexpr EGLint kAny = EGL_DONT_CARE;

// The empty mask of conformance tells the truth: rays do not pass the tests of OpenGL ES. The caveat that said the same
// is obsolete since there is the mask, and each config does all that the others do, as fast. [EGL 1.5, 3.4]
constexpr ConfigAttribute kAttributes[] = {
    {EGL_BUFFER_SIZE, Match::AtLeast, 0, countValue,
     [](const Config &c, const NativeTraits &) { return c.bufferSize(); }},
    {EGL_RED_SIZE, Match::AtLeast, 0, countValue, member<&Config::red>},
    {EGL_GREEN_SIZE, Match::AtLeast, 0, countValue, member<&Config::green>},
    {EGL_BLUE_SIZE, Match::AtLeast, 0, countValue, member<&Config::blue>},
    {EGL_LUMINANCE_SIZE, Match::AtLeast, 0, countValue, constant<0>},
    {EGL_ALPHA_SIZE, Match::AtLeast, 0, countValue, member<&Config::alpha>},
    {EGL_ALPHA_MASK_SIZE, Match::AtLeast, 0, countValue, constant<0>},
    {EGL_BIND_TO_TEXTURE_RGB, Match::Exact, kAny, booleanValue, constant<EGL_TRUE>},
    {EGL_BIND_TO_TEXTURE_RGBA, Match::Exact, kAny, booleanValue,
     [](const Config &c, const NativeTraits &) -> EGLint { return c.alpha > 0; }},
    {EGL_COLOR_BUFFER_TYPE, Match::Exact, EGL_RGB_BUFFER, oneOf<EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER>,
     constant<EGL_RGB_BUFFER>},
    {EGL_CONFIG_CAVEAT, Match::Exact, kAny, oneOf<EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG>,
     constant<EGL_NONE>},
    {EGL_CONFIG_ID, Match::Exact, kAny, anyValue, member<&Config::id>},
    {EGL_CONFORMANT, Match::Mask, 0, bitsOf<kApiBits>, constant<0>},
    {EGL_DEPTH_SIZE, Match::AtLeast, 0, countValue, member<&Config::depth>},
    {EGL_LEVEL, Match::Exact, 0, anyValue, constant<0>},
    {EGL_MAX_PBUFFER_WIDTH, Match::Ignored, kAny, anyValue, constant<kLargestSide>},
    {EGL_MAX_PBUFFER_HEIGHT, Match::Ignored, kAny, anyValue, constant<kLargestSide>},
    {EGL_MAX_PBUFFER_PIXELS, Match::Ignored, kAny, anyValue, constant<kLargestSide * kLargestSide>},
    // A swap waits for no retrace.
    {EGL_MAX_SWAP_INTERVAL, Match::Exact, kAny, countValue, constant<0>},
    {EGL_MIN_SWAP_INTERVAL, Match::Exact, kAny, countValue, constant<0>},
    {EGL_NATIVE_RENDERABLE, Match::Exact, kAny, booleanValue, constant<EGL_FALSE>},
    {EGL_NATIVE_VISUAL_ID, Match::Ignored, kAny, anyValue,
     [](const Config &, const NativeTraits &native) { return native.visualId; }},
    {EGL_NATIVE_VISUAL_TYPE, Match::Exact, kAny, anyValue,
     [](const Config &, const NativeTraits &native) { return native.visualType; }},
    {EGL_RENDERABLE_TYPE, Match::Mask, EGL_OPENGL_ES_BIT, bitsOf<kApiBits>, constant<EGL_OPENGL_ES_BIT>},
    {EGL_SAMPLE_BUFFERS, Match::AtLeast, 0, countValue,
     [](const Config &c, const NativeTraits &) -> EGLint { return c.samples > 0; }},
    {EGL_SAMPLES, Match::AtLeast, 0, countValue, member<&Config::samples>},
    {EGL_STENCIL_SIZE, Match::AtLeast, 0, countValue, constant<0>},
    {EGL_SURFACE_TYPE, Match::Mask, EGL_WINDOW_BIT, bitsOf<kSurfaceBits>, surfaceTypes},
    {EGL_TRANSPARENT_TYPE, Match::Exact, EGL_NONE, oneOf<EGL_NONE, EGL_TRANSPARENT_RGB>, constant<EGL_NONE>},
    // No config is transparent, so there is nothing to compare.
    {EGL_TRANSPARENT_RED_VALUE, Match::Ignored, kAny, countValue, constant<0>},
    {EGL_TRANSPARENT_GREEN_VALUE, Match::Ignored, kAny, countValue, constant<0>},
    {EGL_TRANSPARENT_BLUE_VALUE, Match::Ignored, kAny, countValue, constant<0>},
};

}  // namespace

std::span<const Config> configs() { return kConfigs; }

std::span<const ConfigAttribute> configAttributes() { return kAttributes; }

const ConfigAttribute *findConfigAttribute(EGLAttrib name) {
  const auto *found = std::find_if(std::begin(kAttributes), std::end(kAttributes),
                                   [&](const ConfigAttribute &row) { return row.name == name; });
  return found == std::end(kAttributes) ? nullptr : found;
}

std::optional<EGLint> Config::attribute(EGLint name, const NativeTraits &native) const {
  const ConfigAttribute *row = findConfigAttribute(name);
  return row ? std::optional(row->value(*this, native)) : std::nullopt;
}

}  // namespace rc::egl
