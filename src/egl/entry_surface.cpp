// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: surfaces and swaps. [spec 5; G D 1.3; EGL 1.4, 3.5, 3.9]
#include "egl/entry.h"
#include "egl/swap.h"

using namespace rc;
using namespace rc::egl;

namespace {

constexpr Size kDefaultWindow{800, 480};
constexpr EGLint kLargestSide = 16384;

// Window attributes of EGL 1.4; all surfaces have one back buffer, so there is nothing to choose.
void checkWindowAttributes(const EGLint *attributes) {
  for (const EGLint *at = attributes; at && *at != EGL_NONE; at += 2) {
    require(at[0] == EGL_RENDER_BUFFER || at[0] == EGL_VG_COLORSPACE || at[0] == EGL_VG_ALPHA_FORMAT,
            EGL_BAD_ATTRIBUTE);
  }
}

Size pbufferSize(const EGLint *attributes) {
  Size size;
  for (const EGLint *at = attributes; at && *at != EGL_NONE; at += 2) {
    switch (at[0]) {
      case EGL_WIDTH:
        size.width = at[1];
        break;
      case EGL_HEIGHT:
        size.height = at[1];
        break;
      case EGL_LARGEST_PBUFFER:
      case EGL_TEXTURE_FORMAT:
      case EGL_TEXTURE_TARGET:
      case EGL_MIPMAP_TEXTURE:
      case EGL_VG_COLORSPACE:
      case EGL_VG_ALPHA_FORMAT:
        break;
      default:
        throw EglError{EGL_BAD_ATTRIBUTE};
    }
  }
  require(size.width >= 0 && size.height >= 0, EGL_BAD_PARAMETER);
  require(size.width <= kLargestSide && size.height <= kLargestSide, EGL_BAD_ALLOC);
  return size;
}

// A window of the program, or for null one of our own, or off-screen where there is no window system.
std::shared_ptr<Surface> makeWindowSurface(Display &display, const Config &config, EGLNativeWindowType native) {
  Platform *platform = display.connect();
  if (!native && !platform) return std::make_shared<Surface>(config, kDefaultWindow, nullptr);
  require(platform, EGL_BAD_NATIVE_WINDOW);
  std::unique_ptr<NativeWindow> window = native ? platform->adopt(native) : platform->create(kDefaultWindow);
  require(window != nullptr, EGL_BAD_NATIVE_WINDOW);
  const std::optional<Size> size = window->size();
  require(size.has_value(), EGL_BAD_NATIVE_WINDOW);
  return std::make_shared<Surface>(config, *size, std::move(window));
}

EGLint surfaceAttribute(const Surface &surface, EGLint name) {
  switch (name) {
    case EGL_CONFIG_ID:
      return surface.config().id;
    case EGL_WIDTH:
      return surface.size().width;
    case EGL_HEIGHT:
      return surface.size().height;
    case EGL_RENDER_BUFFER:
      return EGL_BACK_BUFFER;
    case EGL_SWAP_BEHAVIOR:
      return EGL_BUFFER_PRESERVED;
    case EGL_MULTISAMPLE_RESOLVE:
      return EGL_MULTISAMPLE_RESOLVE_DEFAULT;
    case EGL_LARGEST_PBUFFER:
      return EGL_FALSE;
    case EGL_TEXTURE_FORMAT:
    case EGL_TEXTURE_TARGET:
      return EGL_NO_TEXTURE;
    case EGL_MIPMAP_TEXTURE:
    case EGL_MIPMAP_LEVEL:
      return 0;
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
      return EGL_UNKNOWN;
    default:
      throw EglError{EGL_BAD_ATTRIBUTE};
  }
}

}  // namespace

extern "C" {

EGLSurface eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType window,
                                  const EGLint *attributes) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const Config &chosen = configOf(config);
    checkWindowAttributes(attributes);
    return display.surfaces.add(makeWindowSurface(display, chosen, window));
  });
}

EGLSurface eglCreatePbufferSurface(EGLDisplay dpy, EGLConfig config, const EGLint *attributes) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const Config &chosen = configOf(config);
    return display.surfaces.add(std::make_shared<Surface>(chosen, pbufferSize(attributes), nullptr));
  });
}

EGLBoolean eglDestroySurface(EGLDisplay dpy, EGLSurface surface) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    surfaceOf(display, surface);
    display.surfaces.remove(surface);
    return EGL_TRUE;
  });
}

EGLBoolean eglQuerySurface(EGLDisplay dpy, EGLSurface surface, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    const EGLint found = surfaceAttribute(*surfaceOf(initializedDisplay(dpy), surface), name);
    if (value) *value = found;
    return EGL_TRUE;
  });
}

// Pictures are shown when they are done; there is no vertical retrace to wait for.
EGLBoolean eglSwapInterval(EGLDisplay dpy, EGLint) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    initializedDisplay(dpy);
    require(thread.context != nullptr, EGL_BAD_CONTEXT);
    require(thread.draw != nullptr, EGL_BAD_SURFACE);
    return EGL_TRUE;
  });
}

EGLBoolean eglSwapBuffers(EGLDisplay dpy, EGLSurface handle) {
  // Tracing takes long: only the handles are looked up under the lock.
  std::shared_ptr<Surface> surface;
  std::shared_ptr<RenderContext> context;
  const EGLBoolean valid = enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    surface = surfaceOf(initializedDisplay(dpy), handle);
    require(thread.draw == surface, EGL_BAD_SURFACE);
    context = thread.context;
    return EGL_TRUE;
  });
  if (!valid) return EGL_FALSE;
  try {
    if (swapBuffers(*context, *surface)) return EGL_TRUE;
    threadState().error = EGL_BAD_NATIVE_WINDOW;
  } catch (const std::exception &) {
    threadState().error = EGL_BAD_ALLOC;
  }
  return EGL_FALSE;
}

}  // extern "C"
