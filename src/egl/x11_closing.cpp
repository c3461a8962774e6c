// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learns when a program closes its connection to an X server. Xlib tells its extensions, and anybody may be one.
#include "egl/platform.h"

// After everything else: it has macros named min and max.
#include <X11/Xlibint.h>

namespace rc::egl {
namespace {

using Closed = void (*)(void *native);
Closed sClosed = nullptr;  // there is one who wants to know

int notifyClosed(::Display *display, XExtCodes *) {
  sClosed(display);
  return 0;
}

}  // namespace

bool watchX11(void *native, Closed closed) {
  auto *display = static_cast<::Display *>(native);
  sClosed = closed;
  const XExtCodes *codes = XAddExtension(display);
  if (codes) XESetCloseDisplay(display, codes->extension, notifyClosed);
  return codes != nullptr;
}

}  // namespace rc::egl
