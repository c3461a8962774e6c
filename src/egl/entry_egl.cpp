// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: EGL. [spec 5; G D 1.2, 1.3; EGL 1.4, chapter 3]
// Each function checks its handles, acts, and leaves its verdict as the thread's error.

// The system's header says nothing about visibility; these are the symbols to export.
#pragma GCC visibility push(default)
#include <EGL/egl.h>
#pragma GCC visibility pop

#include <cstring>
#include <utility>

#include "RC/rcu.h"
#include "egl/swap.h"

using namespace rc;
using namespace rc::egl;

namespace {

constexpr Size kDefaultWindow{800, 480};
constexpr EGLint kLargestSide = 16384;

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

void require(bool condition, EGLint code) {
  if (!condition) throw EglError{code};
}

Display &displayOf(EGLDisplay handle) {
  Display *display = findDisplay(handle);
  require(display, EGL_BAD_DISPLAY);
  return *display;
}

Display &initializedDisplay(EGLDisplay handle) {
  Display &display = displayOf(handle);
  require(display.initialized, EGL_NOT_INITIALIZED);
  return display;
}

const Config &configOf(EGLConfig handle) {
  for (const Config &config : configs()) {
    if (&config == handle) return config;
  }
  throw EglError{EGL_BAD_CONFIG};
}

std::shared_ptr<Surface> surfaceOf(Display &display, EGLSurface handle) {
  auto surface = display.surfaces.find(handle);
  require(surface != nullptr, EGL_BAD_SURFACE);
  return surface;
}

std::shared_ptr<RenderContext> contextOf(Display &display, EGLContext handle) {
  auto context = display.contexts.find(handle);
  require(context != nullptr, EGL_BAD_CONTEXT);
  return context;
}

EGLBoolean returnConfigs(std::span<const Config *const> found, EGLConfig *out, EGLint size, EGLint *count) {
  const auto all = static_cast<EGLint>(found.size());
  const EGLint given = out ? std::min(all, std::max(size, 0)) : all;
  for (EGLint i = 0; out && i < given; ++i) out[i] = const_cast<Config *>(found[size_t(i)]);
  *count = given;
  return EGL_TRUE;
}

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

void checkContextAttributes(const EGLint *attributes) {
  const bool lenient = api::profileNamed(settings().profile).anyContextAttribute;
  for (const EGLint *at = attributes; at && *at != EGL_NONE && !lenient; at += 2) {
    require(at[0] == EGL_CONTEXT_CLIENT_VERSION, EGL_BAD_ATTRIBUTE);
    require(at[1] == 1, EGL_BAD_MATCH);
  }
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

// Everything current on the thread is finished.
EGLBoolean finishCurrent(ThreadState &thread) {
  if (thread.context) thread.context->api.finish();
  return EGL_TRUE;
}

}  // namespace

extern "C" {

EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
  return enter<EGLDisplay>(EGL_NO_DISPLAY, [&](ThreadState &) { return displayFor(native); });
}

EGLBoolean eglInitialize(EGLDisplay dpy, EGLint *major, EGLint *minor) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    displayOf(dpy).initialized = true;
    if (major) *major = 1;
    if (minor) *minor = 4;
    return EGL_TRUE;
  });
}

// What is current on some thread lives on there; its handle is gone.
EGLBoolean eglTerminate(EGLDisplay dpy) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = displayOf(dpy);
    display.surfaces.clear();
    display.contexts.clear();
    display.platform = nullptr;
    display.initialized = false;
    return EGL_TRUE;
  });
}

const char *eglQueryString(EGLDisplay dpy, EGLint name) {
  return enter<const char *>(nullptr, [&](ThreadState &) -> const char * {
    initializedDisplay(dpy);
    switch (name) {
      case EGL_VENDOR:
        return "Siliconarts";
      case EGL_VERSION:
        return "1.4 RayCore";
      case EGL_CLIENT_APIS:
        return "OpenGL_ES";
      case EGL_EXTENSIONS:
        return "";
      default:
        throw EglError{EGL_BAD_PARAMETER};
    }
  });
}

EGLBoolean eglGetConfigs(EGLDisplay dpy, EGLConfig *out, EGLint size, EGLint *count) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy);
    require(count, EGL_BAD_PARAMETER);
    return returnConfigs(*matchConfigs(nullptr), out, size, count);
  });
}

EGLBoolean eglChooseConfig(EGLDisplay dpy, const EGLint *attributes, EGLConfig *out, EGLint size, EGLint *count) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy);
    require(count, EGL_BAD_PARAMETER);
    const auto matching = matchConfigs(attributes);
    require(matching.has_value(), EGL_BAD_ATTRIBUTE);
    return returnConfigs(*matching, out, size, count);
  });
}

EGLBoolean eglGetConfigAttrib(EGLDisplay dpy, EGLConfig handle, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy);
    const std::optional<EGLint> found = configOf(handle).attribute(name);
    require(found.has_value(), EGL_BAD_ATTRIBUTE);
    require(value, EGL_BAD_PARAMETER);
    *value = *found;
    return EGL_TRUE;
  });
}

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

EGLBoolean eglBindAPI(EGLenum api) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    require(api == EGL_OPENGL_ES_API, EGL_BAD_PARAMETER);
    thread.api = api;
    return EGL_TRUE;
  });
}

EGLenum eglQueryAPI(void) { return threadState().api; }

EGLBoolean eglReleaseThread(void) {
  return enter<EGLBoolean>(EGL_FALSE, [](ThreadState &thread) {
    thread.makeCurrent(EGL_NO_DISPLAY, nullptr, nullptr);
    thread.api = EGL_OPENGL_ES_API;
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

EGLContext eglCreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share, const EGLint *attributes) {
  return enter<EGLContext>(EGL_NO_CONTEXT, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const Config &chosen = configOf(config);
    checkContextAttributes(attributes);
    std::shared_ptr<api::SharedObjects> objects;
    if (share != EGL_NO_CONTEXT) objects = contextOf(display, share)->api.shared();
    return display.contexts.add(std::make_shared<RenderContext>(chosen, settings(), std::move(objects)));
  });
}

EGLBoolean eglDestroyContext(EGLDisplay dpy, EGLContext context) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    contextOf(display, context);
    display.contexts.remove(context);
    return EGL_TRUE;
  });
}

EGLBoolean eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext context) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const bool release = context == EGL_NO_CONTEXT && draw == EGL_NO_SURFACE && read == EGL_NO_SURFACE;
    if (release) {
      displayOf(dpy);  // may be terminated already
      thread.makeCurrent(EGL_NO_DISPLAY, nullptr, nullptr);
      return EGL_TRUE;
    }
    Display &display = initializedDisplay(dpy);
    require(context != EGL_NO_CONTEXT && draw != EGL_NO_SURFACE && read != EGL_NO_SURFACE, EGL_BAD_MATCH);
    auto newContext = contextOf(display, context);
    auto newDraw = surfaceOf(display, draw);
    surfaceOf(display, read);
    require(!newContext->current || newContext == thread.context, EGL_BAD_ACCESS);
    require(!newDraw->current || newDraw == thread.draw, EGL_BAD_ACCESS);
    require(newContext->config.compatibleWith(newDraw->config()), EGL_BAD_MATCH);
    thread.makeCurrent(dpy, std::move(newContext), std::move(newDraw));
    return EGL_TRUE;
  });
}

EGLContext eglGetCurrentContext(void) { return threadState().context.get(); }

EGLDisplay eglGetCurrentDisplay(void) { return threadState().display; }

EGLSurface eglGetCurrentSurface(EGLint readdraw) {
  return enter<EGLSurface>(EGL_NO_SURFACE, [&](ThreadState &thread) {
    require(readdraw == EGL_READ || readdraw == EGL_DRAW, EGL_BAD_PARAMETER);
    return thread.draw.get();
  });
}

EGLBoolean eglQueryContext(EGLDisplay dpy, EGLContext context, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const auto found = contextOf(initializedDisplay(dpy), context);
    EGLint result = 0;
    switch (name) {
      case EGL_CONFIG_ID:
        result = found->config.id;
        break;
      case EGL_CONTEXT_CLIENT_TYPE:
        result = EGL_OPENGL_ES_API;
        break;
      case EGL_CONTEXT_CLIENT_VERSION:
        result = 1;
        break;
      case EGL_RENDER_BUFFER:
        result = found == thread.context && thread.draw ? EGL_BACK_BUFFER : EGL_NONE;
        break;
      default:
        throw EglError{EGL_BAD_ATTRIBUTE};
    }
    if (value) *value = result;
    return EGL_TRUE;
  });
}

EGLBoolean eglWaitClient(void) { return enter<EGLBoolean>(EGL_FALSE, finishCurrent); }

EGLBoolean eglWaitGL(void) { return enter<EGLBoolean>(EGL_FALSE, finishCurrent); }

EGLBoolean eglWaitNative(EGLint engine) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    require(engine == EGL_CORE_NATIVE_ENGINE, EGL_BAD_PARAMETER);
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

EGLint eglGetError(void) { return std::exchange(threadState().error, EGL_SUCCESS); }

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char *name) {
  using Function = __eglMustCastToProperFunctionPointerType;
  struct Row {
    const char *name;
    Function function;
  };
#define RC_ENTRY(entry) {#entry, reinterpret_cast<Function>(entry)},
  static const Row kEntries[] = {
#include "api/entry_points.inc"
#include "egl/entry_points.inc"
  };
#undef RC_ENTRY
  for (const Row &row : kEntries) {
    if (name && !std::strcmp(row.name, name)) return row.function;
  }
  return nullptr;
}

}  // extern "C"
