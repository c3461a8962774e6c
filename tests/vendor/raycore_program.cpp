// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A program linked to both libEGL and libRayCoreAPI draws with rc*, whichever of them its egl* functions come from.
// Argument: the library they must come from.
#include <dlfcn.h>

#include "program.h"

int main(int argc, char **argv) {
  expect(argc == 2, "usage: raycore_program LIBRARY");
  Dl_info info{};
  expect(dladdr(dlsym(RTLD_DEFAULT, "eglInitialize"), &info) != 0, "dladdr");
  expect(std::strstr(info.dli_fname, argv[1]) != nullptr, info.dli_fname);

  const Drawing drawing = draw(surfaceless(), EGL_OPENGL_ES_BIT, 1);
  expect(!std::strcmp(eglQueryString(drawing.display, EGL_VENDOR), "Siliconarts"), "another vendor's display");
  traceColour(drawing, 1, 0);
  traceColour(drawing, 0, 1);

  // A function of an extension finds its display's vendor.
  const auto createSync = reinterpret_cast<PFNEGLCREATESYNCKHRPROC>(eglGetProcAddress("eglCreateSyncKHR"));
  const auto waitSync = reinterpret_cast<PFNEGLCLIENTWAITSYNCKHRPROC>(eglGetProcAddress("eglClientWaitSyncKHR"));
  expect(createSync && waitSync, "eglGetProcAddress");
  const EGLSyncKHR sync = createSync(drawing.display, EGL_SYNC_FENCE_KHR, nullptr);
  expect(waitSync(drawing.display, sync, 0, EGL_FOREVER_KHR) == EGL_CONDITION_SATISFIED_KHR, "eglClientWaitSyncKHR");
  expect(!createSync(drawing.display, EGL_WIDTH, nullptr) && eglGetError() == EGL_BAD_ATTRIBUTE, "its error is lost");
  expect(!eglGetProcAddress("eglGetElapsedTime"), "eglGetElapsedTime must not be there");

  expect(eglMakeCurrent(drawing.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), "release");
  expect(eglTerminate(drawing.display), "eglTerminate");
  return EXIT_SUCCESS;
}
