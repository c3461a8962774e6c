// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// twins.h: what functions of the core share with their EXT and KHR twins, whose
// attribute lists are narrower.
#pragma once

#include "egl/display.h"

namespace rc::egl {

// All throw EglError. Those that wait for something take the display lock themselves; the others are called under it.
Display *platformDisplay(EGLenum platform, void *native, Attributes list);

// native: a pointer to a Window or Pixmap. [EGL_KHR_platform_x11] The first takes the lock.
EGLSurface createPlatformWindowSurface(EGLDisplay dpy, EGLConfig config, const void *native, Attributes list);
EGLSurface createPlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, const void *native, Attributes list);

// error: of a type that is none; the core and the extension differ. [EGL 1.5, 3.8.1; EGL_KHR_fence_sync]
EGLSync createSync(EGLDisplay dpy, EGLenum type, Attributes list, EGLint error);
EGLAttrib syncAttribute(EGLDisplay dpy, EGLSync sync, EGLint name);

// Takes the lock.
EGLImage createImage(EGLDisplay dpy, EGLContext context, EGLenum target, EGLClientBuffer buffer, Attributes list);

}  // namespace rc::egl
