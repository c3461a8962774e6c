// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11_errors.h: X errors of one connection are noted, and Xlib's error handler, of which a process has one, is not
// asked: it is the program's.
#pragma once

#include <X11/Xlib.h>

#include <atomic>
#include <memory>

namespace rc::egl {

class X11Errors {
 public:
  // From now on, for as long as the connection is open. The object must live as long.
  explicit X11Errors(::Display *display);
  ~X11Errors();
  X11Errors(const X11Errors &) = delete;
  X11Errors &operator=(const X11Errors &) = delete;

  // Whether there was one since forget().
  bool noted() const { return mNoted; }
  void forget() { mNoted = false; }

 private:
  struct Hook;

  std::atomic<bool> mNoted = false;
  std::unique_ptr<Hook> mHook;
};

}  // namespace rc::egl
