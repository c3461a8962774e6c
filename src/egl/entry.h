// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// entry.h: what every egl* function is made of: it checks its handles, acts, and leaves its verdict as the error of
// the thread. [EGL 1.4, 3.1]
#pragma once

// The system's header says nothing about visibility; these are the symbols to export.
#pragma GCC visibility push(default)
#include <EGL/egl.h>
#pragma GCC visibility pop

#include "egl/thread.h"

namespace rc::egl {

// Thrown inside a call, never out of it: the error code of a check that failed.
struct EglError {
  EGLint code;
};

// Runs body under the display lock; its result, or `failure` and the error.
template <class Result, class Body>
Result enter(Result failure, Body &&body) noexcept {
  ThreadState &thread = threadState();
  try {
    const std::lock_guard lock(displayMutex());
    thread.error = EGL_SUCCESS;
    return body(thread);
  } catch (const EglError &error) {
    thread.error = error.code;
  } catch (const std::exception &) {
    thread.error = EGL_BAD_ALLOC;
  }
  return failure;
}

inline void require(bool condition, EGLint code) {
  if (!condition) throw EglError{code};
}

inline Display &displayOf(EGLDisplay handle) {
  Display *display = findDisplay(handle);
  require(display, EGL_BAD_DISPLAY);
  return *display;
}

inline Display &initializedDisplay(EGLDisplay handle) {
  Display &display = displayOf(handle);
  require(display.initialized, EGL_NOT_INITIALIZED);
  return display;
}

inline const Config &configOf(EGLConfig handle) {
  for (const Config &config : configs()) {
    if (&config == handle) return config;
  }
  throw EglError{EGL_BAD_CONFIG};
}

inline std::shared_ptr<Surface> surfaceOf(Display &display, EGLSurface handle) {
  auto surface = display.surfaces.find(handle);
  require(surface != nullptr, EGL_BAD_SURFACE);
  return surface;
}

inline std::shared_ptr<RenderContext> contextOf(Display &display, EGLContext handle) {
  auto context = display.contexts.find(handle);
  require(context != nullptr, EGL_BAD_CONTEXT);
  return context;
}

}  // namespace rc::egl
