// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// thread.h: what EGL keeps for each thread: the last error, the bound API, what is current. [EGL 1.5, 2.4]
#pragma once

#include "egl/display.h"

namespace rc::egl {

// What eglMakeCurrent makes current: nothing, a context without surfaces, or one with both.
struct Current {
  Display *display = nullptr;
  std::shared_ptr<RenderContext> context;
  std::shared_ptr<Surface> draw, read;

  bool operator==(const Current &) const = default;
};

struct ThreadState {
  EGLint error = EGL_SUCCESS;
  EGLenum api = EGL_OPENGL_ES_API;
  Current current;

  ~ThreadState();
  // Waits for the picture of the current context that is on its way: not under the display lock.
  void awaitPicture() const;
  // What was current is let go. Throws without memory, and what was current still is.
  void makeCurrent(Current next);
};

ThreadState &threadState();

}  // namespace rc::egl
