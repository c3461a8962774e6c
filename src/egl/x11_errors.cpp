// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/x11_errors.h"

#include <X11/Xlibint.h>  // the hooks that Xlib offers to libraries on it; defines names that nobody else may see

namespace rc::egl {
namespace {

// Asked for each answer of the server. True: it is done with.
Bool noteError(::Display *, xReply *answer, char *, int, XPointer noted) {
  if (answer->generic.type != X_Error) return False;
  *reinterpret_cast<std::atomic<bool> *>(noted) = true;
  return True;
}

}  // namespace

struct X11Errors::Hook {
  _XAsyncHandler entry;
};

X11Errors::X11Errors(::Display *display) : mHook(new Hook{}) {
  mHook->entry.handler = noteError;
  mHook->entry.data = reinterpret_cast<XPointer>(&mNoted);
  LockDisplay(display);
  mHook->entry.next = display->async_handlers;
  display->async_handlers = &mHook->entry;
  UnlockDisplay(display);
}

X11Errors::~X11Errors() = default;

}  // namespace rc::egl
