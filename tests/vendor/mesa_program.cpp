// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Mesa's OpenGL ES 2 in one context, RayCore in another, in one program and on one thread, through libEGL.so.1.
// With the argument "alone" no vendor is named, and RayCore must not be there.
#include <GLES2/gl2.h>

#include "program.h"

namespace {

bool isMesa(EGLDisplay display) { return std::strstr(eglQueryString(display, EGL_VENDOR), "Mesa") != nullptr; }

// A software device of Mesa's, or none.
EGLDisplay mesaDisplay() {
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT devices[8];
  EGLint count = 0;
  if (!queryDevices || !queryDevices(8, devices, &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i) {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) && isMesa(display)) return display;
  }
  return EGL_NO_DISPLAY;
}

void clearGreenWithMesa() {
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  unsigned char pixel[4] = {};
  glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  expect(pixel[0] == 0 && pixel[1] == 255 && pixel[2] == 0, "Mesa's picture is not green");
}

}  // namespace

int main(int argc, char **argv) {
  const bool alone = argc > 1 && !std::strcmp(argv[1], "alone");
  const EGLDisplay mesa = alone ? surfaceless() : mesaDisplay();
  if (mesa == EGL_NO_DISPLAY || !isMesa(mesa)) {
    if (alone) fail("RayCore was not asked for");
    std::puts("skipped: Mesa has no device for OpenGL ES 2 here");
    return kSkip;
  }
  const Drawing gl = draw(mesa, EGL_OPENGL_ES2_BIT, 2);
  clearGreenWithMesa();
  if (alone) return EXIT_SUCCESS;
  const Drawing raycore = draw(surfaceless(), EGL_OPENGL_ES_BIT, 1);
  expect(!isMesa(raycore.display), "Mesa's display instead of RayCore's");
  traceColour(raycore, 1, 0);
  for (int i = 0; i < 3; ++i) {
    expect(gl.makeCurrent(), "back to Mesa");
    clearGreenWithMesa();
    expect(raycore.makeCurrent(), "back to RayCore");
    traceColour(raycore, float(i % 2), float((i + 1) % 2));
    glClear(GL_COLOR_BUFFER_BIT);  // while RayCore is current it does nothing, and comes back
  }
  return EXIT_SUCCESS;
}
