// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: surfaces and their attributes. [spec 5; G D 1.3; EGL 1.5, 3.5]
#include "egl/entry.h"
#include "egl/twins.h"

using namespace rc;
using namespace rc::egl;

namespace {

constexpr Size kDefaultWindow{800, 480};

// What the size decides, of the surface that is drawn to: a program asks for it before its next frame.
EGLint sizeAttribute(Surface &surface, EGLint name) {
  const Size next = surface.nextSize();
  if (name == EGL_WIDTH) return next.width;
  if (name == EGL_HEIGHT) return next.height;
  return next == surface.size() ? surface.age() : 0;  // EGL_BUFFER_AGE_EXT: pixels of another size will be lost
}
bool isOfSize(EGLint name) { return name == EGL_WIDTH || name == EGL_HEIGHT || name == EGL_BUFFER_AGE_EXT; }

EGLSurface add(Display &display, const Config &config, EGLint kind, const SurfaceAttributes &attributes, Size size,
               std::unique_ptr<NativeDrawable> drawable, EGLNativeWindowType native) {
  return display.surfaces.add(std::make_shared<Surface>(config, kind, attributes, size, std::move(drawable), native));
}

// A window or pixmap has one surface at most.
void requireNoSurface(const Display &display, EGLint kind, EGLNativeWindowType native) {
  require(!display.surfaces.any([&](const Surface &other) { return other.kind() == kind && other.native() == native; }),
          EGL_BAD_ALLOC);
}

EGLSurface addNative(Display &display, const Config &config, EGLint kind, const SurfaceAttributes &attributes,
                     std::unique_ptr<NativeDrawable> drawable, EGLNativeWindowType native, EGLint error) {
  require(drawable != nullptr, error);
  const std::optional<Size> size = drawable->size();
  require(size.has_value(), error);
  return add(display, config, kind, attributes, *size, std::move(drawable), native);
}

// What a window surface is to be, and the window system that has the window; null where there is none.
struct WindowRequest {
  const Config &config;
  SurfaceAttributes attributes;
  std::shared_ptr<Platform> platform;
};

WindowRequest readWindowRequest(EGLDisplay dpy, EGLConfig config, Attributes list) {
  const std::lock_guard lock(displayMutex());
  Display &display = initializedDisplay(dpy);
  const Config &chosen = configOf(config);
  const SurfaceAttributes attributes = readSurfaceAttributes(EGL_WINDOW_BIT, chosen, list);
  require(display.key.platform != EGL_PLATFORM_SURFACELESS_MESA, EGL_BAD_NATIVE_WINDOW);
  return {chosen, attributes, display.connect()};
}

// A window of the program, or for null one of our own, or off-screen where there is no window system. The window may
// have to be waited for: that is done without the lock.
EGLSurface createWindowSurface(EGLDisplay dpy, const WindowRequest &wanted, EGLNativeWindowType native) {
  require(!native || wanted.platform, EGL_BAD_NATIVE_WINDOW);
  std::unique_ptr<NativeDrawable> window;
  if (wanted.platform) {
    window = native ? wanted.platform->adoptWindow(native) : wanted.platform->createWindow(kDefaultWindow);
    require(window != nullptr, EGL_BAD_NATIVE_WINDOW);
  }
  const std::lock_guard lock(displayMutex());
  Display &display = initializedDisplay(dpy);
  if (!window) return add(display, wanted.config, EGL_WINDOW_BIT, wanted.attributes, kDefaultWindow, nullptr, 0);
  if (native) requireNoSurface(display, EGL_WINDOW_BIT, native);
  return addNative(display, wanted.config, EGL_WINDOW_BIT, wanted.attributes, std::move(window), native,
                   EGL_BAD_NATIVE_WINDOW);
}

EGLSurface createPixmapSurface(EGLDisplay dpy, EGLConfig config, EGLNativePixmapType native, Attributes list) {
  Display &display = initializedDisplay(dpy);
  const Config &chosen = configOf(config);
  const SurfaceAttributes attributes = readSurfaceAttributes(EGL_PIXMAP_BIT, chosen, list);
  const std::shared_ptr<Platform> platform = display.connect();
  const std::optional<bool> works = platform ? platform->holdsPictures(native) : std::nullopt;
  require(works.has_value(), EGL_BAD_NATIVE_PIXMAP);
  require(*works, EGL_BAD_MATCH);
  requireNoSurface(display, EGL_PIXMAP_BIT, native);
  return addNative(display, chosen, EGL_PIXMAP_BIT, attributes, platform->adoptPixmap(native), native,
                   EGL_BAD_NATIVE_PIXMAP);
}

Size pbufferSize(const SurfaceAttributes &wanted) {
  if (wanted.largestPbuffer) return {std::min(wanted.width, kLargestSide), std::min(wanted.height, kLargestSide)};
  require(wanted.width <= kLargestSide && wanted.height <= kLargestSide, EGL_BAD_ALLOC);
  return {wanted.width, wanted.height};
}

}  // namespace

namespace rc::egl {

EGLSurface createPlatformWindowSurface(EGLDisplay dpy, EGLConfig config, const void *native, Attributes list) {
  const WindowRequest wanted = readWindowRequest(dpy, config, list);
  require(native, EGL_BAD_NATIVE_WINDOW);
  return createWindowSurface(dpy, wanted, *static_cast<const unsigned long *>(native));
}

EGLSurface createPlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, const void *native, Attributes list) {
  initializedDisplay(dpy);
  configOf(config);
  require(native, EGL_BAD_NATIVE_PIXMAP);
  return createPixmapSurface(dpy, config, *static_cast<const unsigned long *>(native), list);
}

}  // namespace rc::egl

extern "C" {

EGLSurface eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType window,
                                  const EGLint *attributes) {
  return enterUnlocked<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    return createWindowSurface(dpy, readWindowRequest(dpy, config, Attributes(attributes)), window);
  });
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void *native, const EGLAttrib *attributes) {
  return enterUnlocked<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    return createPlatformWindowSurface(dpy, config, native, Attributes(attributes));
  });
}

EGLSurface eglCreatePixmapSurface(EGLDisplay dpy, EGLConfig config, EGLNativePixmapType pixmap,
                                  const EGLint *attributes) {
  return enter<EGLSurface>(
      EGL_NO_SURFACE, [&](ThreadState &) { return createPixmapSurface(dpy, config, pixmap, Attributes(attributes)); });
}

EGLSurface eglCreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, void *native, const EGLAttrib *attributes) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    return createPlatformPixmapSurface(dpy, config, native, Attributes(attributes));
  });
}

EGLSurface eglCreatePbufferSurface(EGLDisplay dpy, EGLConfig config, const EGLint *attributes) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const Config &chosen = configOf(config);
    const SurfaceAttributes wanted = readSurfaceAttributes(EGL_PBUFFER_BIT, chosen, Attributes(attributes));
    return add(display, chosen, EGL_PBUFFER_BIT, wanted, pbufferSize(wanted), nullptr, 0);
  });
}

// Only OpenVG has such buffers, and there is no OpenVG.
EGLSurface eglCreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig config,
                                            const EGLint *) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &) -> EGLSurface {
    initializedDisplay(dpy);
    configOf(config);
    throw EglError{EGL_BAD_PARAMETER};
  });
}

EGLBoolean eglDestroySurface(EGLDisplay dpy, EGLSurface surface) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    display.surfaces.destroy(*surfaceOf(display, surface));
    return EGL_TRUE;
  });
}

EGLBoolean eglSurfaceAttrib(EGLDisplay dpy, EGLSurface surface, EGLint name, EGLint value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    setSurfaceAttribute(*surfaceOf(initializedDisplay(dpy), surface), name, value);
    return EGL_TRUE;
  });
}

EGLBoolean eglQuerySurface(EGLDisplay dpy, EGLSurface handle, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const auto surface = surfaceOf(initializedDisplay(dpy), handle);
    const bool current = thread.current.draw == surface;
    require(current || name != EGL_BUFFER_AGE_EXT, EGL_BAD_SURFACE);
    const std::optional<EGLint> found =
        current && isOfSize(name) ? sizeAttribute(*surface, name) : surfaceAttribute(*surface, name);
    require(value, EGL_BAD_PARAMETER);
    if (found) *value = *found;
    return EGL_TRUE;
  });
}

}  // extern "C"
