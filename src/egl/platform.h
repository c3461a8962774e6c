// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// platform.h: what a window system does for EGL: tell the size of a window or pixmap and show a picture in it.
// Off-screen surfaces have no NativeDrawable, displays without a window system no Platform.
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <optional>

#include "egl/config.h"
#include "rchal/device.h"

namespace rc::egl {

struct alignas(8) Size {  // so that an atomic one is a word, also for Clang without optimisation
  int width = 0, height = 0;
  bool operator==(const Size &) const = default;
};

// A window or a pixmap.
class NativeDrawable {
 public:
  virtual ~NativeDrawable() = default;
  // Nothing if it is gone.
  virtual std::optional<Size> size() = 0;
  // False if it is gone.
  virtual bool present(const hal::Target &picture) = 0;
  // The user asked to close a window that the library itself made.
  virtual bool closeRequested() { return false; }
};

// A connection to a window system.
class Platform {
 public:
  virtual ~Platform() = default;
  // Its default visual.
  virtual NativeTraits traits() const = 0;
  // Null if there is no such window; throws EGL_BAD_MATCH for one that shows no colours of its own, but those of a
  // palette. Waits for windows that are on their way.
  virtual std::unique_ptr<NativeDrawable> adoptWindow(EGLNativeWindowType window) = 0;
  // A window of the library's own, for programs that pass none. [G D 1.5]
  virtual std::unique_ptr<NativeDrawable> createWindow(Size size) = 0;
  // Whether pictures can be stored in a pixmap: some have no colours. Nothing for what is no pixmap.
  virtual std::optional<bool> holdsPictures(EGLNativePixmapType pixmap) = 0;
  // A pixmap that holds pictures.
  virtual std::unique_ptr<NativeDrawable> adoptPixmap(EGLNativePixmapType pixmap) = 0;
};

// Connects to the X server of a program's connection (an Xlib Display *), or to the default one for null; null
// without a server. screen: below 0 for the connection's default one.
std::shared_ptr<Platform> connectX11(void *native, int screen);

// Calls `closed` when the program closes its connection. False without memory.
bool watchX11(void *native, void (*closed)(void *native));

}  // namespace rc::egl
