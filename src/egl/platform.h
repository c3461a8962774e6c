// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// platform.h: what a window system does for EGL: tell a window's size and show a picture in it.
// Without a window there is nothing to do: off-screen surfaces have no NativeWindow.
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <optional>

#include "rchal/device.h"

namespace rc::egl {

struct Size {
  int width = 0, height = 0;
  bool operator==(const Size &) const = default;
};

class NativeWindow {
 public:
  virtual ~NativeWindow() = default;
  // Nothing if the window is gone.
  virtual std::optional<Size> size() = 0;
  // False if the window is gone.
  virtual bool present(const hal::Target &picture) = 0;
  // The user asked to close a window that the library itself made.
  virtual bool closeRequested() = 0;
};

// A connection to a window system.
class Platform {
 public:
  virtual ~Platform() = default;
  // Null if there is no such window.
  virtual std::unique_ptr<NativeWindow> adopt(EGLNativeWindowType window) = 0;
  // A window of the library's own, for programs that pass none. [G D 1.5]
  virtual std::unique_ptr<NativeWindow> create(Size size) = 0;
};

// Connects to the X server of the given display, or the default one for null; null without a server.
std::unique_ptr<Platform> connectX11(EGLNativeDisplayType native);

}  // namespace rc::egl
