// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11_connection.h: a connection to an X server of our own, which outlives the server. The program's connection may be
// in use by another thread, and it ends the program when the server goes away.
#pragma once

#include <X11/Xlib.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <optional>

#include "egl/pixel_format.h"
#include "egl/x11_errors.h"

namespace rc::egl {

class X11Connection {
 public:
  // Null where there is no server. screen: below 0 for the default one.
  static std::shared_ptr<X11Connection> open(const char *name, int screen);
  ~X11Connection();
  X11Connection(const X11Connection &) = delete;
  X11Connection &operator=(const X11Connection &) = delete;

  ::Display *display() const { return mDisplay; }
  int screen() const { return mScreen; }
  ::Window root() const { return RootWindow(mDisplay, mScreen); }
  // False once the server has gone; nothing can be asked any more. So it is in the child of a fork: the connection is
  // its parent's.
  bool alive() const { return mAlive && mProcess == getpid(); }
  // Of requests made under an ErrorTrap.
  X11Errors &errors() const { return mErrors; }
  // Whether pixels of a visual are colours, not places in a palette.
  static bool holdsColours(const ::Visual &visual) {
    return visual.c_class == TrueColor || visual.c_class == DirectColor;
  }
  // The visual for windows: the screen's default one, if it holds colours, or another that does; null if none does.
  ::Visual *windowVisual() const;
  // Where pixmaps of a depth have their colours; nothing for depths without any.
  std::optional<ColourMasks> masksOf(int depth) const;

 private:
  X11Connection(::Display *display, int screen);
  static void serverGone(::Display *, void *connection);

  ::Display *mDisplay;
  int mScreen;
  pid_t mProcess = getpid();
  std::atomic<bool> mAlive = true;
  mutable X11Errors mErrors;
};

// While it lives, X errors of one connection, and its loss, are noted instead of ending the program. What happens to
// other connections goes to the program's handlers. One at a time in the process; all that asks the server is done
// under one, after a look whether the connection is alive: the thread that found it broken keeps Xlib's lock on it for
// ever.
class ErrorTrap {
 public:
  explicit ErrorTrap(const X11Connection &connection);
  ~ErrorTrap();  // waits for the server's answers
  ErrorTrap(const ErrorTrap &) = delete;
  ErrorTrap &operator=(const ErrorTrap &) = delete;

  // Waits for the server's answers to all that was asked; true if one was an error, or if nobody answers any more.
  bool failed() const;

 private:
  void sync() const;

  const X11Connection &mConnection;
};

}  // namespace rc::egl
