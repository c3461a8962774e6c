// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: displays, strings, errors. [spec 5; EGL 1.5, 3.1 to 3.3]
#include <utility>

#include "egl/entry.h"
#include "egl/twins.h"

using namespace rc;
using namespace rc::egl;

namespace {

constexpr char kVersion[] = "1.5 RayCore";
constexpr char kClientExtensions[] =
    "EGL_EXT_client_extensions EGL_EXT_platform_base EGL_EXT_platform_x11 EGL_KHR_client_get_all_proc_addresses "
    "EGL_KHR_platform_x11 EGL_MESA_platform_surfaceless";
constexpr char kDisplayExtensions[] =
    "EGL_EXT_buffer_age EGL_KHR_create_context EGL_KHR_fence_sync EGL_KHR_get_all_proc_addresses "
    "EGL_KHR_gl_texture_2D_image EGL_KHR_image_base EGL_KHR_surfaceless_context EGL_KHR_swap_buffers_with_damage "
    "EGL_KHR_wait_sync";

const char *clientString(EGLint name) {
  require(name == EGL_EXTENSIONS || name == EGL_VERSION, EGL_BAD_DISPLAY);
  return name == EGL_VERSION ? kVersion : kClientExtensions;
}

const char *displayString(EGLint name) {
  switch (name) {
    case EGL_VENDOR:
      return "Siliconarts";
    case EGL_VERSION:
      return kVersion;
    case EGL_CLIENT_APIS:
      return "OpenGL_ES";
    case EGL_EXTENSIONS:
      return kDisplayExtensions;
    default:
      throw EglError{EGL_BAD_PARAMETER};
  }
}

// A program that names X11 needs it; the default display does without where there is none.
bool windowSystemWorks(Display &display) {
  return display.key.platform != EGL_PLATFORM_X11_KHR || display.connect() != nullptr;
}

EGLint numberAfter(Attributes list, EGLAttrib name, EGLint otherwise) {
  EGLint number = otherwise;
  for (; list.more(); list.advance()) {
    require(list.name() == name, EGL_BAD_ATTRIBUTE);
    number = list.number();
    require(number >= 0, EGL_BAD_ATTRIBUTE);
  }
  return number;
}

}  // namespace

namespace rc::egl {

Display *platformDisplay(EGLenum platform, void *native, Attributes list) {
  if (platform == EGL_PLATFORM_X11_KHR) {
    return displayFor({platform, native, numberAfter(list, EGL_PLATFORM_X11_SCREEN_KHR, -1)});
  }
  require(platform == EGL_PLATFORM_SURFACELESS_MESA && !native, EGL_BAD_PARAMETER);
  require(!list.more(), EGL_BAD_ATTRIBUTE);
  return displayFor({platform});
}

}  // namespace rc::egl

extern "C" {

EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
  return enter<EGLDisplay>(EGL_NO_DISPLAY, [&](ThreadState &) {
    return displayFor({native ? EGLenum{EGL_PLATFORM_X11_KHR} : EGLenum{EGL_NONE}, native});
  });
}

EGLDisplay eglGetPlatformDisplay(EGLenum platform, void *native, const EGLAttrib *attributes) {
  return enter<EGLDisplay>(EGL_NO_DISPLAY,
                           [&](ThreadState &) { return platformDisplay(platform, native, Attributes(attributes)); });
}

EGLBoolean eglInitialize(EGLDisplay dpy, EGLint *major, EGLint *minor) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = displayOf(dpy);
    require(windowSystemWorks(display), EGL_NOT_INITIALIZED);
    display.initialized = true;
    if (major) *major = 1;
    if (minor) *minor = 5;
    return EGL_TRUE;
  });
}

// What is current on some thread lives on there; its handle is gone.
EGLBoolean eglTerminate(EGLDisplay dpy) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = displayOf(dpy);
    display.surfaces.clear();
    display.contexts.clear();
    display.syncs.clear();
    display.images.clear();
    display.platform = nullptr;
    display.initialized = false;
    return EGL_TRUE;
  });
}

const char *eglQueryString(EGLDisplay dpy, EGLint name) {
  return enter<const char *>(nullptr, [&](ThreadState &) {
    if (dpy == EGL_NO_DISPLAY) return clientString(name);
    initializedDisplay(dpy);
    return displayString(name);
  });
}

EGLint eglGetError(void) { return std::exchange(threadState().error, EGL_SUCCESS); }

}  // extern "C"
