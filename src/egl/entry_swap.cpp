// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: pictures are shown, copied, waited for. [spec 5; EGL 1.5, 3.8, 3.10]
// Tracing takes long: handles are looked up under the lock, and the rest is done without it. A context is current on
// one thread, so nobody else touches it.
#include "egl/entry.h"
#include "egl/swap.h"

using namespace rc;
using namespace rc::egl;

namespace {

EGLint goneError(const Surface &surface) {
  return surface.kind() == EGL_PIXMAP_BIT ? EGL_BAD_NATIVE_PIXMAP : EGL_BAD_NATIVE_WINDOW;
}

// Everything current on the thread is finished.
EGLBoolean finishCurrent() {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [](ThreadState &thread) {
    const Current &current = thread.current;
    if (current.context) current.context->api.complete();
    require(!current.draw || !current.draw->gone(), EGL_BAD_CURRENT_SURFACE);
    return EGL_TRUE;
  });
}

// A pixmap that eglCopyBuffers may write to.
std::unique_ptr<NativeDrawable> adoptTarget(Display &display, EGLNativePixmapType target) {
  const std::shared_ptr<Platform> platform = display.connect();
  const std::optional<bool> works = platform ? platform->holdsPictures(target) : std::nullopt;
  require(works.has_value(), EGL_BAD_NATIVE_PIXMAP);
  require(*works, EGL_BAD_MATCH);
  return platform->adoptPixmap(target);
}

}  // namespace

extern "C" {

EGLBoolean eglSwapBuffers(EGLDisplay dpy, EGLSurface handle) {
  std::shared_ptr<Surface> surface;
  const EGLBoolean valid = enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    surface = surfaceOf(initializedDisplay(dpy), handle);
    require(thread.current.draw == surface, EGL_BAD_SURFACE);
    return EGL_TRUE;
  });
  if (!valid) return EGL_FALSE;
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    require(swapBuffers(*thread.current.context, surface), goneError(*surface));
    return EGL_TRUE;
  });
}

// The surface itself shows nothing new.
EGLBoolean eglCopyBuffers(EGLDisplay dpy, EGLSurface handle, EGLNativePixmapType target) {
  std::shared_ptr<Surface> surface;
  std::unique_ptr<NativeDrawable> pixmap;
  const EGLBoolean valid = enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    Display &display = initializedDisplay(dpy);
    surface = surfaceOf(display, handle);
    pixmap = adoptTarget(display, target);
    require(thread.current.draw == surface, EGL_BAD_SURFACE);
    return EGL_TRUE;
  });
  if (!valid) return EGL_FALSE;
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    thread.current.context->api.complete();
    require(pixmap && pixmap->present(surface->picture()), EGL_BAD_NATIVE_PIXMAP);
    return EGL_TRUE;
  });
}

// Pictures are shown when they are done; every interval is clamped to 0, the only one.
EGLBoolean eglSwapInterval(EGLDisplay dpy, EGLint) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    initializedDisplay(dpy);
    require(thread.current.context != nullptr, EGL_BAD_CONTEXT);
    require(thread.current.draw != nullptr, EGL_BAD_SURFACE);
    return EGL_TRUE;
  });
}

EGLBoolean eglWaitClient(void) { return finishCurrent(); }

EGLBoolean eglWaitGL(void) { return finishCurrent(); }

// The window system shows what it was given before the program waited for it with eglWaitClient.
EGLBoolean eglWaitNative(EGLint engine) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    require(engine == EGL_CORE_NATIVE_ENGINE, EGL_BAD_PARAMETER);
    require(!thread.current.draw || thread.current.draw->checkNative(), EGL_BAD_CURRENT_SURFACE);
    return EGL_TRUE;
  });
}

}  // extern "C"
