// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/display.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <vector>

namespace rc::egl {
namespace {

// Made on first use and never destroyed: programs call EGL from constructors and destructors of globals.
std::vector<std::unique_ptr<Display>> &displays() {
  static auto &all = *new std::vector<std::unique_ptr<Display>>;
  return all;
}

// The next display of X11 at the same address is another one.
void forgetNative(void *native) {
  const std::lock_guard lock(displayMutex());
  for (const auto &display : displays()) {
    if (display->key.native == native) display->nativeClosed = true;
  }
}

}  // namespace

std::shared_ptr<Platform> Display::connect() {
  if (platform || nativeClosed || key.platform == EGL_PLATFORM_SURFACELESS_MESA) return platform;
  platform = connectX11(key.native, key.screen);
  if (platform && key.native && !watched) watched = watchX11(key.native, forgetNative);
  return platform;
}

NativeTraits Display::traits() {
  if (key.platform == EGL_PLATFORM_SURFACELESS_MESA) return {.surfaceTypes = EGL_PBUFFER_BIT};
  const std::shared_ptr<Platform> connected = connect();
  return connected ? connected->traits() : NativeTraits();
}

Display *displayFor(const DisplayKey &key) {
  for (const auto &display : displays()) {
    if (display->key == key && !display->nativeClosed) return display.get();
  }
  return displays().emplace_back(std::make_unique<Display>(Display{.key = key})).get();
}

Display *findDisplay(EGLDisplay handle) {
  for (const auto &display : displays()) {
    if (display.get() == handle) return display.get();
  }
  return nullptr;
}

bool belongsToAnotherDisplay(const Display &display, EGLContext context) {
  return std::ranges::any_of(
      displays(), [&](const auto &other) { return other.get() != &display && other->contexts.find(context); });
}

ForkMutex &displayMutex() {
  static auto &mutex = *new ForkMutex;
  return mutex;
}

}  // namespace rc::egl
