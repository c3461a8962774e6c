// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// thread.h: what EGL keeps for each thread: the last error, the bound API, what is current. [EGL 1.4, 2.4]
#pragma once

#include "egl/display.h"

namespace rc::egl {

struct ThreadState {
  EGLint error = EGL_SUCCESS;
  EGLenum api = EGL_OPENGL_ES_API;
  EGLDisplay display = EGL_NO_DISPLAY;
  std::shared_ptr<RenderContext> context;
  std::shared_ptr<Surface> draw;

  ~ThreadState();
  // Makes a context and a surface current, or none; the old ones are let go.
  void makeCurrent(EGLDisplay newDisplay, std::shared_ptr<RenderContext> newContext, std::shared_ptr<Surface> newDraw);
};

ThreadState &threadState();

}  // namespace rc::egl
