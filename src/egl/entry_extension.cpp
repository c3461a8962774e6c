// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Functions of extensions: mostly the core's under the names they had before, with narrower attributes. A program gets
// them from eglGetProcAddress; extension_points.inc lists them.
#include "egl/entry.h"
#include "egl/twins.h"

using namespace rc;
using namespace rc::egl;

namespace {

EGLDisplay getPlatformDisplayEXT(EGLenum platform, void *native, const EGLint *attributes) {
  return enter<EGLDisplay>(EGL_NO_DISPLAY,
                           [&](ThreadState &) { return platformDisplay(platform, native, Attributes(attributes)); });
}

EGLSurface createPlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config, void *native, const EGLint *attributes) {
  return enterUnlocked<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    return createPlatformWindowSurface(dpy, config, native, Attributes(attributes));
  });
}

EGLSurface createPlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig config, void *native, const EGLint *attributes) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    return createPlatformPixmapSurface(dpy, config, native, Attributes(attributes));
  });
}

EGLSyncKHR createSyncKHR(EGLDisplay dpy, EGLenum type, const EGLint *attributes) {
  return enter<EGLSyncKHR>(
      EGL_NO_SYNC_KHR, [&](ThreadState &) { return createSync(dpy, type, Attributes(attributes), EGL_BAD_ATTRIBUTE); });
}

EGLBoolean getSyncAttribKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    const EGLAttrib found = syncAttribute(dpy, sync, name);
    require(value, EGL_BAD_PARAMETER);
    *value = static_cast<EGLint>(found);
    return EGL_TRUE;
  });
}

EGLint waitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags) {
  return static_cast<EGLint>(eglWaitSync(dpy, sync, flags));
}

EGLImageKHR createImageKHR(EGLDisplay dpy, EGLContext context, EGLenum target, EGLClientBuffer buffer,
                           const EGLint *attributes) {
  return enterUnlocked<EGLImageKHR>(EGL_NO_IMAGE_KHR, [&](ThreadState &) {
    return createImage(dpy, context, target, buffer, Attributes(attributes));
  });
}

// The whole picture is shown whatever has changed of it.
EGLBoolean swapBuffersWithDamageKHR(EGLDisplay dpy, EGLSurface surface, const EGLint *rectangles, EGLint count) {
  const EGLBoolean valid = enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    surfaceOf(initializedDisplay(dpy), surface);
    require(count >= 0 && (count == 0 || rectangles), EGL_BAD_PARAMETER);
    return EGL_TRUE;
  });
  return valid ? eglSwapBuffers(dpy, surface) : EGL_FALSE;
}

}  // namespace

namespace rc::egl {

std::span<const NamedFunction> extensionFunctions() {
#define RC_EXTENSION(name, function) {#name, reinterpret_cast<__eglMustCastToProperFunctionPointerType>(function)},
  static const NamedFunction kExtensions[] = {
#include "egl/extension_points.inc"
  };
#undef RC_EXTENSION
  return kExtensions;
}

}  // namespace rc::egl
