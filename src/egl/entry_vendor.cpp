// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: the vendor's own beside EGL's. [reference 1.5]
#include <cstdio>
#include <memory>

#include "egl/entry.h"
#include "egl/vendor_calls.h"

using namespace rc;
using namespace rc::egl;

namespace {

void writeReport(std::FILE *file, const Display &display) {
  const Settings &process = settings();
  std::fprintf(file, "device: %s\nthreads: %d\nprofile: %s\n", process.device.c_str(), process.threads,
               process.profile.c_str());
  std::fprintf(file, "surfaces: %zu\ncontexts: %zu\n", display.surfaces.size(), display.contexts.size());
  const std::shared_ptr<RenderContext> &context = threadState().current.context;
  if (context) std::fprintf(file, "last frame: %s\n", ddk::describe(context->api.lastFrame()).c_str());
}

}  // namespace

extern "C" {

void eglDumpSystemRC(EGLDisplay dpy, const char *fileName) {
  enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    const Display &display = initializedDisplay(dpy);
    require(fileName != nullptr, EGL_BAD_PARAMETER);
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(fileName, "w"), std::fclose);
    require(file != nullptr, EGL_BAD_PARAMETER);
    writeReport(file.get(), display);
    return EGL_TRUE;
  });
}

EGLBoolean eglGetReportRegister(EGLDisplay dpy, int *count, void *report) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy);
    require(count != nullptr && report == nullptr, EGL_BAD_PARAMETER);
    *count = 1;
    return EGL_TRUE;
  });
}

}  // extern "C"
