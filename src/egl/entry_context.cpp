// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: contexts. [spec 5; EGL 1.5, 3.7.1, 3.7.2, 3.7.4]
#include <algorithm>

#include "egl/entry.h"

using namespace rc;
using namespace rc::egl;

namespace {

// What a list asks for. [EGL 1.5, table 3.6; EGL_KHR_create_context]
struct ContextAttributes {
  EGLint major = 1, minor = 0;
  EGLint flags = 0, debug = EGL_FALSE, robust = EGL_FALSE;
  EGLint reset = EGL_NO_RESET_NOTIFICATION;
};

struct Row {
  EGLint name;
  EGLint ContextAttributes::*member;
  ValueCheck valid;
};
// Attributes for OpenGL alone are not here.
constexpr Row kRows[] = {
    {EGL_CONTEXT_MAJOR_VERSION, &ContextAttributes::major, anyValue},
    {EGL_CONTEXT_MINOR_VERSION, &ContextAttributes::minor, anyValue},
    {EGL_CONTEXT_FLAGS_KHR, &ContextAttributes::flags,
     bitsOf<EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR | EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR>},
    {EGL_CONTEXT_OPENGL_DEBUG, &ContextAttributes::debug, booleanValue},
    {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, &ContextAttributes::robust, booleanValue},
    {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, &ContextAttributes::reset,
     oneOf<EGL_NO_RESET_NOTIFICATION, EGL_LOSE_CONTEXT_ON_RESET>},
};

// The versions of OpenGL ES there are; ours is 1.x, and no config is for another.
void checkVersion(EGLint major, EGLint minor) {
  const bool later = (major == 2 && minor == 0) || (major == 3 && minor >= 0 && minor <= 2);
  require(!later, EGL_BAD_CONFIG);
  require(major == 1 && (minor == 0 || minor == 1), EGL_BAD_MATCH);
}

void checkContextAttributes(Attributes list) {
  ContextAttributes wanted;
  for (; list.more(); list.advance()) {
    const auto *row =
        std::find_if(std::begin(kRows), std::end(kRows), [&](const Row &r) { return r.name == list.name(); });
    require(row != std::end(kRows) && row->valid(list.number()), EGL_BAD_ATTRIBUTE);
    wanted.*row->member = list.number();
  }
  checkVersion(wanted.major, wanted.minor);
  // Client arrays are read wherever they point to, and nothing is ever reset.
  const bool robust = wanted.robust || wanted.flags & EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR;
  require(!robust && wanted.reset == EGL_NO_RESET_NOTIFICATION, EGL_BAD_MATCH);
}

std::shared_ptr<api::SharedObjects> objectsOf(Display &display, EGLContext share) {
  if (share == EGL_NO_CONTEXT) return nullptr;
  require(!belongsToAnotherDisplay(display, share), EGL_BAD_MATCH);
  return contextOf(display, share)->api.shared();
}

// What draws go to, not what was asked for.
EGLint renderBuffer(const RenderContext &context, const Current &current) {
  if (current.context.get() != &context || !current.draw) return EGL_NONE;
  return current.draw->showsAtOnce() ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER;
}

EGLint contextAttribute(const RenderContext &context, EGLint name, const Current &current) {
  switch (name) {
    case EGL_CONFIG_ID:
      return context.config.id;
    case EGL_CONTEXT_CLIENT_TYPE:
      return EGL_OPENGL_ES_API;
    case EGL_CONTEXT_CLIENT_VERSION:
      return 1;
    case EGL_RENDER_BUFFER:
      return renderBuffer(context, current);
    default:
      throw EglError{EGL_BAD_ATTRIBUTE};
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

EGLenum eglQueryAPI(void) {
  return enterUnlocked<EGLenum>(EGL_NONE, [](ThreadState &thread) { return thread.api; });
}

EGLContext eglCreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share, const EGLint *attributes) {
  return enter<EGLContext>(EGL_NO_CONTEXT, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const Config &chosen = configOf(config);
    if (!api::profileNamed(settings().profile).anyContextAttribute) checkContextAttributes(Attributes(attributes));
    return display.contexts.add(std::make_shared<RenderContext>(chosen, settings(), objectsOf(display, share)));
  });
}

EGLBoolean eglDestroyContext(EGLDisplay dpy, EGLContext context) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    display.contexts.destroy(*contextOf(display, context));
    return EGL_TRUE;
  });
}

EGLBoolean eglQueryContext(EGLDisplay dpy, EGLContext context, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const EGLint found = contextAttribute(*contextOf(initializedDisplay(dpy), context), name, thread.current);
    require(value, EGL_BAD_PARAMETER);
    *value = found;
    return EGL_TRUE;
  });
}

}  // extern "C"
