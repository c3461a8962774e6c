// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: configs. [spec 5; EGL 1.5, 3.4]
#include "egl/entry.h"

using namespace rc;
using namespace rc::egl;

namespace {

// Without room to write to, all are counted; otherwise those that were written.
EGLBoolean returnConfigs(std::span<const Config *const> found, EGLConfig *out, EGLint size, EGLint *count) {
  const auto all = static_cast<EGLint>(found.size());
  const EGLint given = out ? std::min(all, std::max(size, 0)) : all;
  for (EGLint i = 0; out && i < given; ++i) out[i] = const_cast<Config *>(found[size_t(i)]);
  *count = given;
  return EGL_TRUE;
}

}  // namespace

extern "C" {

EGLBoolean eglGetConfigs(EGLDisplay dpy, EGLConfig *out, EGLint size, EGLint *count) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy);
    require(count, EGL_BAD_PARAMETER);
    std::vector<const Config *> all;
    for (const Config &config : configs()) all.push_back(&config);
    return returnConfigs(all, out, size, count);
  });
}

EGLBoolean eglChooseConfig(EGLDisplay dpy, const EGLint *attributes, EGLConfig *out, EGLint size, EGLint *count) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    require(count, EGL_BAD_PARAMETER);
    const auto pixmapWorks = [&](EGLNativePixmapType pixmap) -> std::optional<bool> {
      const std::shared_ptr<Platform> platform = display.connect();
      return platform ? platform->holdsPictures(pixmap) : std::nullopt;
    };
    const auto chosen = chooseConfigs(Attributes(attributes), display.traits(), pixmapWorks);
    require(chosen.has_value(), EGL_BAD_ATTRIBUTE);
    return returnConfigs(*chosen, out, size, count);
  });
}

EGLBoolean eglGetConfigAttrib(EGLDisplay dpy, EGLConfig handle, EGLint name, EGLint *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    const std::optional<EGLint> found = configOf(handle).attribute(name, display.traits());
    require(found.has_value(), EGL_BAD_ATTRIBUTE);
    require(value, EGL_BAD_PARAMETER);
    *value = *found;
    return EGL_TRUE;
  });
}

}  // extern "C"
