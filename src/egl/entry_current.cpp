// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: what is current on a thread. [spec 5; EGL 1.5, 3.7.3, 3.12]
#include "egl/entry.h"

using namespace rc;
using namespace rc::egl;

namespace {

void checkSurface(Surface &surface, const RenderContext &context, const Current &current) {
  const bool ours = current.draw.get() == &surface || current.read.get() == &surface;
  require(!surface.current || ours, EGL_BAD_ACCESS);
  require(context.config.compatibleWith(surface.config()), EGL_BAD_MATCH);
  require(surface.checkNative(), surface.kind() == EGL_PIXMAP_BIT ? EGL_BAD_NATIVE_PIXMAP : EGL_BAD_NATIVE_WINDOW);
}

// What the handles mean, once all that eglMakeCurrent asks of them is checked.
Current checkedCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext context, const Current &current) {
  Display &display = initializedDisplay(dpy);
  Current next{&display, nullptr, nullptr, nullptr};
  if (draw != EGL_NO_SURFACE) next.draw = surfaceOf(display, draw);
  if (read != EGL_NO_SURFACE) next.read = surfaceOf(display, read);
  require(context != EGL_NO_CONTEXT, EGL_BAD_MATCH);
  next.context = contextOf(display, context);
  require(!next.draw == !next.read, EGL_BAD_MATCH);
  require(!next.context->current || next.context == current.context, EGL_BAD_ACCESS);
  if (!next.draw) return next;
  checkSurface(*next.draw, *next.context, current);
  checkSurface(*next.read, *next.context, current);
  return next;
}

template <class Object>
void *handleOf(const std::shared_ptr<Object> &object) {
  return object ? object->handle : nullptr;
}

bool isCurrent(const Current &current, EGLSurface draw, EGLSurface read, EGLContext context) {
  return handleOf(current.draw) == draw && handleOf(current.read) == read && handleOf(current.context) == context;
}

}  // namespace

extern "C" {

EGLBoolean eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext context) {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    if (!isCurrent(thread.current, draw, read, context)) thread.awaitPicture();
    const std::lock_guard lock(displayMutex());
    if (draw == EGL_NO_SURFACE && read == EGL_NO_SURFACE && context == EGL_NO_CONTEXT) {
      displayOf(dpy);  // may be terminated already
      thread.makeCurrent({});
    } else {
      thread.makeCurrent(checkedCurrent(dpy, draw, read, context, thread.current));
    }
    return EGL_TRUE;
  });
}

EGLContext eglGetCurrentContext(void) {
  return enterUnlocked<EGLContext>(EGL_NO_CONTEXT,
                                   [](ThreadState &thread) { return handleOf(thread.current.context); });
}

EGLDisplay eglGetCurrentDisplay(void) {
  return enterUnlocked<EGLDisplay>(EGL_NO_DISPLAY, [](ThreadState &thread) { return thread.current.display; });
}

EGLSurface eglGetCurrentSurface(EGLint readdraw) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &thread) {
    require(readdraw == EGL_READ || readdraw == EGL_DRAW, EGL_BAD_PARAMETER);
    return handleOf(readdraw == EGL_DRAW ? thread.current.draw : thread.current.read);
  });
}

EGLBoolean eglReleaseThread(void) {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [](ThreadState &thread) {
    thread.awaitPicture();
    const std::lock_guard lock(displayMutex());
    thread.makeCurrent({});
    thread.api = EGL_OPENGL_ES_API;
    return EGL_TRUE;
  });
}

}  // extern "C"
