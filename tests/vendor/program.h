// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// program.h: what the programs of the vendor tests have in common. They use nothing but the public interfaces.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <RC/rc.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

constexpr int kSkip = 77;

[[noreturn]] inline void fail(const char *what) {
  std::fprintf(stderr, "%s (EGL error 0x%x)\n", what, unsigned(eglGetError()));
  std::exit(EXIT_FAILURE);
}

inline void expect(bool condition, const char *what) {
  if (!condition) fail(what);
}

// A display with a pbuffer and a context that is current.
struct Drawing {
  EGLDisplay display;
  EGLSurface surface;
  EGLContext context;

  bool makeCurrent() const { return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE; }
};

inline Drawing draw(EGLDisplay display, EGLint renderable, EGLint version) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, renderable, EGL_RED_SIZE, 8,
                           EGL_NONE};
  const EGLint size[] = {EGL_WIDTH, 32, EGL_HEIGHT, 16, EGL_NONE};
  const EGLint client[] = {EGL_CONTEXT_CLIENT_VERSION, version, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  expect(eglChooseConfig(display, wanted, &config, 1, &count) && count == 1, "eglChooseConfig");
  const Drawing drawing{display, eglCreatePbufferSurface(display, config, size),
                        eglCreateContext(display, config, EGL_NO_CONTEXT, client)};
  expect(drawing.makeCurrent(), "eglMakeCurrent");
  return drawing;
}

inline EGLDisplay surfaceless() {
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  expect(display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr), "eglInitialize");
  return display;
}

// Clears to a colour with rc* and swaps; RAYCORE_CAPTURE, a PPM, tells what came of it.
inline void traceColour(const Drawing &drawing, float red, float blue) {
  RCint viewport[4] = {};
  rcGetIntegerv(RC_VIEWPORT, viewport);
  expect(viewport[2] == 32 && viewport[3] == 16, "rc* does not know the current surface");
  rcClearColor(red, 0, blue, 1);
  expect(rcGetError() == RC_NO_ERROR, "rcClearColor");
  expect(eglSwapBuffers(drawing.display, drawing.surface), "eglSwapBuffers");
  std::FILE *file = std::fopen(std::getenv("RAYCORE_CAPTURE"), "rb");
  expect(file != nullptr, "RAYCORE_CAPTURE wrote nothing");
  unsigned char bytes[13 + 3] = {};  // "P6\n32 16\n255\n" and a pixel
  expect(std::fread(bytes, 1, sizeof bytes, file) == sizeof bytes, "RAYCORE_CAPTURE wrote too little");
  std::fclose(file);
  expect(bytes[13] == (red > 0 ? 255 : 0) && bytes[15] == (blue > 0 ? 255 : 0), "the colour is another");
}
