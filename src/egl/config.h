// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// config.h: the frame buffer configurations and how one is chosen. [spec 5; EGL 1.4, 3.4]
#pragma once

#include <EGL/egl.h>

#include <optional>
#include <span>
#include <vector>

namespace rc::egl {

struct Config {
  EGLint id;
  EGLint alphaSize, depthSize;

  EGLint bufferSize() const { return 24 + alphaSize; }
  // Whether contexts of one may draw to surfaces of the other. [EGL 1.4, 2.2]
  bool compatibleWith(const Config &other) const {
    return alphaSize == other.alphaSize && depthSize == other.depthSize;
  }
  // Nothing for names that are no attribute of a config.
  std::optional<EGLint> attribute(EGLint name) const;
};

// In the order in which eglChooseConfig returns them.
std::span<const Config> configs();

// The configs that satisfy an attribute list, or nothing for a list with an unknown attribute.
std::optional<std::vector<const Config *>> matchConfigs(const EGLint *attributes);

}  // namespace rc::egl
