// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/display.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <map>

namespace rc::egl {
namespace {

// Made on first use and never destroyed: programs call EGL from constructors and destructors of globals.
std::map<DisplayKey, std::unique_ptr<Display>> &displays() {
  static auto &all = *new std::map<DisplayKey, std::unique_ptr<Display>>;
  return all;
}

}  // namespace

Platform *Display::connect() {
  if (!platform && key.platform != EGL_PLATFORM_SURFACELESS_MESA) platform = connectX11(key.native, key.screen);
  return platform.get();
}

NativeTraits Display::traits() {
  if (key.platform == EGL_PLATFORM_SURFACELESS_MESA) return {.surfaceTypes = EGL_PBUFFER_BIT};
  const Platform *connected = connect();
  return connected ? connected->traits() : NativeTraits();
}

Display *displayFor(const DisplayKey &key) {
  std::unique_ptr<Display> &display = displays()[key];
  if (!display) display = std::make_unique<Display>(Display{.key = key});
  return display.get();
}

Display *findDisplay(EGLDisplay handle) {
  for (const auto &[key, display] : displays()) {
    if (display.get() == handle) return display.get();
  }
  return nullptr;
}

bool belongsToAnotherDisplay(const Display &display, EGLContext context) {
  return std::ranges::any_of(displays(), [&](const auto &entry) {
    return entry.second.get() != &display && entry.second->contexts.find(context);
  });
}

std::recursive_mutex &displayMutex() {
  static auto &mutex = *new std::recursive_mutex;
  return mutex;
}

}  // namespace rc::egl
