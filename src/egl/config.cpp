// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/config.h"

#include <algorithm>

namespace rc::egl {
namespace {

// Without alpha first, shallow first: EGL's order for equal colour sizes.
constexpr Config kConfigs[] = {{1, 0, 0}, {2, 0, 16}, {3, 0, 24}, {4, 8, 0}, {5, 8, 16}, {6, 8, 24}};

enum class Match { AtLeast, Exact, Mask, Ignored };

struct AttributeRow {
  EGLint name;
  Match match;
  EGLint (*value)(const Config &config);
};

template <EGLint Value>
EGLint constant(const Config &) {
  return Value;
}

constexpr EGLint kLargestPbuffer = 16384;

// Table 3.1 and 3.4 of EGL 1.4.
constexpr AttributeRow kAttributes[] = {
    {EGL_BUFFER_SIZE, Match::AtLeast, [](const Config &c) { return c.bufferSize(); }},
    {EGL_RED_SIZE, Match::AtLeast, constant<8>},
    {EGL_GREEN_SIZE, Match::AtLeast, constant<8>},
    {EGL_BLUE_SIZE, Match::AtLeast, constant<8>},
    {EGL_LUMINANCE_SIZE, Match::AtLeast, constant<0>},
    {EGL_ALPHA_SIZE, Match::AtLeast, [](const Config &c) { return c.alphaSize; }},
    {EGL_ALPHA_MASK_SIZE, Match::AtLeast, constant<0>},
    {EGL_BIND_TO_TEXTURE_RGB, Match::Exact, constant<EGL_FALSE>},
    {EGL_BIND_TO_TEXTURE_RGBA, Match::Exact, constant<EGL_FALSE>},
    {EGL_COLOR_BUFFER_TYPE, Match::Exact, constant<EGL_RGB_BUFFER>},
    {EGL_CONFIG_CAVEAT, Match::Exact, constant<EGL_NONE>},
    {EGL_CONFIG_ID, Match::Exact, [](const Config &c) { return c.id; }},
    {EGL_CONFORMANT, Match::Mask, constant<0>},
    {EGL_DEPTH_SIZE, Match::AtLeast, [](const Config &c) { return c.depthSize; }},
    {EGL_LEVEL, Match::Exact, constant<0>},
    {EGL_MATCH_NATIVE_PIXMAP, Match::Ignored, constant<0>},
    {EGL_MAX_PBUFFER_WIDTH, Match::Ignored, constant<kLargestPbuffer>},
    {EGL_MAX_PBUFFER_HEIGHT, Match::Ignored, constant<kLargestPbuffer>},
    {EGL_MAX_PBUFFER_PIXELS, Match::Ignored, constant<kLargestPbuffer * kLargestPbuffer>},
    {EGL_MAX_SWAP_INTERVAL, Match::Exact, constant<1>},
    {EGL_MIN_SWAP_INTERVAL, Match::Exact, constant<0>},
    {EGL_NATIVE_RENDERABLE, Match::Exact, constant<EGL_FALSE>},
    {EGL_NATIVE_VISUAL_ID, Match::Ignored, constant<0>},
    {EGL_NATIVE_VISUAL_TYPE, Match::Exact, constant<EGL_NONE>},
    {EGL_RENDERABLE_TYPE, Match::Mask, constant<EGL_OPENGL_ES_BIT>},
    {EGL_SAMPLE_BUFFERS, Match::AtLeast, constant<0>},
    {EGL_SAMPLES, Match::AtLeast, constant<0>},
    {EGL_STENCIL_SIZE, Match::AtLeast, constant<0>},
    // The pixmap bit is what a program asks for that wants the full screen. [G D 1.3]
    {EGL_SURFACE_TYPE, Match::Mask, constant<EGL_WINDOW_BIT | EGL_PBUFFER_BIT | EGL_PIXMAP_BIT>},
    {EGL_TRANSPARENT_TYPE, Match::Exact, constant<EGL_NONE>},
    {EGL_TRANSPARENT_RED_VALUE, Match::Ignored, constant<0>},
    {EGL_TRANSPARENT_GREEN_VALUE, Match::Ignored, constant<0>},
    {EGL_TRANSPARENT_BLUE_VALUE, Match::Ignored, constant<0>},
};

const AttributeRow *findAttribute(EGLint name) {
  const auto *found = std::find_if(std::begin(kAttributes), std::end(kAttributes),
                                   [&](const AttributeRow &row) { return row.name == name; });
  return found == std::end(kAttributes) ? nullptr : found;
}

bool satisfies(const AttributeRow &row, EGLint offered, EGLint wanted) {
  if (wanted == EGL_DONT_CARE) return true;
  switch (row.match) {
    case Match::AtLeast:
      return offered >= wanted;
    case Match::Exact:
      return offered == wanted;
    case Match::Mask:
      return (offered & wanted) == wanted;
    case Match::Ignored:
      break;
  }
  return true;
}

}  // namespace

std::optional<EGLint> Config::attribute(EGLint name) const {
  const AttributeRow *row = findAttribute(name);
  return row ? std::optional(row->value(*this)) : std::nullopt;
}

std::span<const Config> configs() { return kConfigs; }

std::optional<std::vector<const Config *>> matchConfigs(const EGLint *attributes) {
  std::vector<const Config *> matching;
  for (const Config &config : kConfigs) matching.push_back(&config);
  for (const EGLint *at = attributes; at && *at != EGL_NONE; at += 2) {
    if (!findAttribute(at[0])) return std::nullopt;
    if (at[0] != EGL_CONFIG_ID || at[1] == EGL_DONT_CARE) continue;
    std::erase_if(matching, [&](const Config *config) { return config->id != at[1]; });  // nothing else counts
    return matching;
  }
  for (const EGLint *at = attributes; at && *at != EGL_NONE; at += 2) {
    const AttributeRow *row = findAttribute(at[0]);
    std::erase_if(matching, [&](const Config *config) { return !satisfies(*row, row->value(*config), at[1]); });
  }
  return matching;
}

}  // namespace rc::egl
