// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/display.h"

namespace rc::egl {
namespace {

// Made on first use and never destroyed: programs call EGL from constructors and destructors of globals.
std::map<EGLNativeDisplayType, std::unique_ptr<Display>> &displays() {
  static auto &all = *new std::map<EGLNativeDisplayType, std::unique_ptr<Display>>;
  return all;
}

}  // namespace

Platform *Display::connect() {
  if (!platform) platform = connectX11(native);
  return platform.get();
}

Display *displayFor(EGLNativeDisplayType native) {
  std::unique_ptr<Display> &display = displays()[native];
  if (!display) display = std::make_unique<Display>(Display{.native = native});
  return display.get();
}

Display *findDisplay(EGLDisplay handle) {
  for (const auto &[native, display] : displays()) {
    if (display.get() == handle) return display.get();
  }
  return nullptr;
}

std::recursive_mutex &displayMutex() {
  static auto &mutex = *new std::recursive_mutex;
  return mutex;
}

}  // namespace rc::egl
