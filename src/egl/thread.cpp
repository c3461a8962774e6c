// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/thread.h"

namespace rc::egl {

ThreadState::~ThreadState() {
  const std::lock_guard lock(displayMutex());
  makeCurrent(EGL_NO_DISPLAY, nullptr, nullptr);
}

void ThreadState::makeCurrent(EGLDisplay newDisplay, std::shared_ptr<RenderContext> newContext,
                              std::shared_ptr<Surface> newDraw) {
  api::setCurrentContext(nullptr);  // first: what follows may run out of memory
  if (context) {
    context->api.attach(nullptr);
    context->current = false;
    draw->current = false;
  }
  display = newDisplay;
  context = std::move(newContext);
  draw = std::move(newDraw);
  if (context) {
    context->current = true;
    draw->current = true;
    context->api.attach(draw.get());
  }
  api::setCurrentContext(context ? &context->api : nullptr);
}

ThreadState &threadState() {
  static thread_local ThreadState state;
  return state;
}

}  // namespace rc::egl
