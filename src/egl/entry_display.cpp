// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: displays, configs, errors, function pointers. [spec 5; EGL 1.4, 3.1 to 3.4, 3.10]
#include <cstring>
#include <utility>

#include "RC/rcu.h"
#include "egl/entry.h"

using namespace rc;
using namespace rc::egl;

namespace {

EGLBoolean returnConfigs(std::span<const Config *const> found, EGLConfig *out, EGLint size, EGLint *count) {
  const auto all = static_cast<EGLint>(found.size());
  const EGLint given = out ? std::min(all, std::max(size, 0)) : all;
  for (EGLint i = 0; out && i < given; ++i) out[i] = const_cast<Config *>(found[size_t(i)]);
  *count = given;
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

EGLint eglGetError(void) { return std::exchange(threadState().error, EGL_SUCCESS); }

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char *name) {
  using Function = __eglMustCastToProperFunctionPointerType;
  struct Row {
    const char *name;
    Function function;
  };
#define RC_ENTRY(entry) {#entry, reinterpret_cast<Function>(entry)},
#define RC_FUNCTION(result, name, ...) RC_ENTRY(name)
  static const Row kEntries[] = {
#include "api/functions.inc"
#include "egl/entry_points.inc"
  };
#undef RC_FUNCTION
#undef RC_ENTRY
  for (const Row &row : kEntries) {
    if (name && !std::strcmp(row.name, name)) return row.function;
  }
  return nullptr;
}

}  // extern "C"
