// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: contexts, what is current, waiting. [spec 5; EGL 1.4, 3.7, 3.8]
#include "egl/entry.h"

using namespace rc;
using namespace rc::egl;

namespace {

void checkContextAttributes(const EGLint *attributes) {
  const bool lenient = api::profileNamed(settings().profile).anyContextAttribute;
  for (const EGLint *at = attributes; at && *at != EGL_NONE && !lenient; at += 2) {
    require(at[0] == EGL_CONTEXT_CLIENT_VERSION, EGL_BAD_ATTRIBUTE);
    require(at[1] == 1, EGL_BAD_MATCH);
  }
}

// Everything current on the thread is finished. A context is current on one thread: no lock is needed, and other
// threads need not wait until the frame is traced.
EGLBoolean finishCurrent() noexcept {
  ThreadState &thread = threadState();
  thread.error = EGL_SUCCESS;
  try {
    if (thread.context) thread.context->api.finish();
    return EGL_TRUE;
  } catch (const std::exception &) {
    thread.error = EGL_BAD_ALLOC;
    return EGL_FALSE;
  }
}

}  // namespace

extern "C" {

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

EGLBoolean eglWaitClient(void) { return finishCurrent(); }

EGLBoolean eglWaitGL(void) { return finishCurrent(); }

EGLBoolean eglWaitNative(EGLint engine) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    require(engine == EGL_CORE_NATIVE_ENGINE, EGL_BAD_PARAMETER);
    return EGL_TRUE;
  });
}

}  // extern "C"
