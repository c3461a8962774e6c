// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11_image.h: a picture on its way to an X server: through shared memory, or through the connection.
#pragma once

#include <X11/Xlib.h>

#include <array>
#include <cstdint>
#include <memory>

#include "rchal/device.h"

namespace rc::egl {

// While it lives, X errors of one connection are noted instead of ending the program. Errors of other
// connections go to the program's handler. One at a time in the process.
class ErrorTrap {
 public:
  explicit ErrorTrap(::Display *display);
  ~ErrorTrap();  // waits for the server's answers
  ErrorTrap(const ErrorTrap &) = delete;
  ErrorTrap &operator=(const ErrorTrap &) = delete;

  // Waits for the server's answers to all that was asked; true if one was an error.
  bool failed() const;

 private:
  ::Display *mDisplay;
};

class X11Image {
 public:
  X11Image(::Display *display, const XWindowAttributes &attributes);
  ~X11Image();
  X11Image(const X11Image &) = delete;
  X11Image &operator=(const X11Image &) = delete;

  // Shows the picture in the upper left corner of the drawable; false if that is gone.
  bool put(::Drawable drawable, const hal::Target &picture);

 private:
  struct Shared;

  bool resize(int width, int height);
  bool makeShared(int width, int height);
  void release();
  void convert(const hal::Target &picture);

  ::Display *mDisplay;
  ::Visual *mVisual;
  int mDepth;
  ::GC mGc = nullptr;
  XImage *mImage = nullptr;
  std::unique_ptr<Shared> mShared;                    // null where pixels go through the connection
  bool mSharedWorks = true;                           // until an attempt fails: remote servers cannot
  std::array<std::array<uint32_t, 256>, 3> mChannel;  // byte of R, G, B -> bits of the visual
};

}  // namespace rc::egl
