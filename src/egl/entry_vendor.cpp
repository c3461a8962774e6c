// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: the vendor's own beside EGL's. [reference 1.5]
#include <fstream>
#include <sstream>
#include <string>

#include "egl/entry.h"
#include "egl/vendor_calls.h"

using namespace rc;
using namespace rc::egl;

namespace {

std::string reportOf(const Display &display, const RenderContext *current) {
  const Settings &process = settings();
  std::ostringstream text;
  text << "device: " << process.device << "\nthreads: " << process.threads << "\nprofile: " << process.profile << '\n';
  text << "surfaces: " << display.surfaces.size() << "\ncontexts: " << display.contexts.size() << '\n';
  if (current) text << "last frame: " << ddk::describe(current->api.lastFrame()) << '\n';
  return text.str();
}

}  // namespace

extern "C" {

// The file may be slow, or a pipe that nobody reads: it is written without the lock.
void eglDumpSystemRC(EGLDisplay dpy, const char *fileName) {
  std::string report;
  const EGLBoolean valid = enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    if (thread.current.context) thread.current.context->api.await();
    const std::lock_guard lock(displayMutex());
    report = reportOf(initializedDisplay(dpy), thread.current.context.get());
    require(fileName != nullptr, EGL_BAD_PARAMETER);
    return EGL_TRUE;
  });
  if (!valid) return;
  enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    std::ofstream file(fileName);
    require(bool(file << report << std::flush), EGL_BAD_PARAMETER);
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
