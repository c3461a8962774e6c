// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// config.h: the frame buffer configurations and how one is chosen. [spec 5; EGL 1.5, 3.4]
#pragma once

#include <EGL/egl.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "egl/attributes.h"

namespace rc::egl {

// What the display's window system adds to every config.
struct NativeTraits {
  EGLint surfaceTypes = EGL_WINDOW_BIT | EGL_PBUFFER_BIT | EGL_PIXMAP_BIT;
  EGLint visualId = 0, visualType = EGL_NONE;
};

inline constexpr EGLint kLargestSide = 16384;  // of an off-screen surface

struct Config {
  EGLint id;
  EGLint red, green, blue, alpha;
  EGLint depth;
  EGLint samples;  // 0: one sample, and no multisample buffer

  constexpr EGLint bufferSize() const { return red + green + blue + alpha; }
  // Whether contexts of one may draw to surfaces of the other. [EGL 1.5, 2.2]
  bool compatibleWith(const Config &other) const { return this == &other; }
  // Nothing for names that are no attribute of a config.
  std::optional<EGLint> attribute(EGLint name, const NativeTraits &native) const;
};

// By id.
std::span<const Config> configs();

// An attribute of configs: what a list may ask for, and how a config meets it. [EGL 1.5, tables 3.1 and 3.4]
enum class Match { AtLeast, Exact, Mask, Ignored };

struct ConfigAttribute {
  EGLint name;
  Match match;
  EGLint initial;  // what a list without it asks for
  ValueCheck valid;
  EGLint (*value)(const Config &config, const NativeTraits &native);
};
const ConfigAttribute *findConfigAttribute(EGLAttrib name);
std::span<const ConfigAttribute> configAttributes();

// Whether surfaces may be made for a native pixmap; nothing for what is no pixmap.
using PixmapCheck = std::function<std::optional<bool>(EGLNativePixmapType pixmap)>;

// The configs that satisfy an attribute list, best first; nothing for a list with an unknown name or value.
std::optional<std::vector<const Config *>> chooseConfigs(Attributes list, const NativeTraits &native,
                                                         const PixmapCheck &pixmapWorks);

}  // namespace rc::egl
