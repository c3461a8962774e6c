// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// entry.h: what every egl* function is made of: it checks its handles, acts, and leaves its verdict as the error of
// the thread. [EGL 1.5, 3.1]
#pragma once

// The system's header says nothing about visibility; these are the symbols to export.
#pragma GCC visibility push(default)
#include <EGL/egl.h>
#pragma GCC visibility pop
#include <EGL/eglext.h>

#include "base/float_mode.h"
#include "egl/error.h"
#include "egl/thread.h"

namespace rc::egl {

// Runs body; its result, or `failure` and the error.
template <class Result, class Body>
Result enterUnlocked(Result failure, Body &&body) noexcept {
  ThreadState &thread = threadState();
  thread.error = EGL_SUCCESS;
  const FloatMode mode;
  try {
    return body(thread);
  } catch (const EglError &error) {
    thread.error = error.code;
  } catch (const std::exception &) {
    thread.error = EGL_BAD_ALLOC;
  }
  return failure;
}

// The same under the display lock, as all that uses displays and handles must be.
template <class Result, class Body>
Result enter(Result failure, Body &&body) noexcept {
  return enterUnlocked<Result>(failure, [&](ThreadState &thread) {
    const std::lock_guard lock(displayMutex());
    return body(thread);
  });
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

// The object of a handle; `error` for handles that are none.
template <class Object>
std::shared_ptr<Object> objectOf(const HandleTable<Object> &table, void *handle, EGLint error) {
  auto object = table.find(handle);
  require(object != nullptr, error);
  return object;
}

inline std::shared_ptr<Surface> surfaceOf(Display &display, EGLSurface handle) {
  return objectOf(display.surfaces, handle, EGL_BAD_SURFACE);
}

inline std::shared_ptr<RenderContext> contextOf(Display &display, EGLContext handle) {
  return objectOf(display.contexts, handle, EGL_BAD_CONTEXT);
}

// What eglGetProcAddress knows.
struct NamedFunction {
  const char *name;
  __eglMustCastToProperFunctionPointerType function;
};
// Those beyond EGL 1.5's core, which are no symbols of the library.
std::span<const NamedFunction> extensionFunctions();

}  // namespace rc::egl
