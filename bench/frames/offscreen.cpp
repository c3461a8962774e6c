// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/offscreen.h"

#include <EGL/egl.h>
#include <RC/rc.h>

#include <cstdio>
#include <cstdlib>

namespace rc::bench {

void useThreads(int threads) { setenv("RAYCORE_THREADS", std::to_string(threads).c_str(), 1); }

Offscreen::Offscreen(int width, int height) : mWidth(width), mHeight(height) {
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  mDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  const EGLint bytes[] = {EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(mDisplay, nullptr, nullptr) || !eglChooseConfig(mDisplay, bytes, &config, 1, &count) ||
      !(mSurface = eglCreatePbufferSurface(mDisplay, config, size)) ||
      !(mContext = eglCreateContext(mDisplay, config, EGL_NO_CONTEXT, nullptr)) ||
      !eglMakeCurrent(mDisplay, mSurface, mSurface, mContext)) {
    std::fprintf(stderr, "EGL error 0x%04X\n", unsigned(eglGetError()));
    std::exit(1);
  }
}

Offscreen::~Offscreen() {
  eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(mDisplay, mContext);
  eglDestroySurface(mDisplay, mSurface);
}

void Offscreen::swap() const { eglSwapBuffers(mDisplay, mSurface); }

void Offscreen::wait() const { eglWaitClient(); }

std::vector<unsigned char> Offscreen::pixels() const {
  std::vector<unsigned char> pixels(size_t(mWidth) * size_t(mHeight) * 4);
  rcReadPixels(0, 0, mWidth, mHeight, RC_RGBA, RC_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

void Offscreen::save(const std::string &path) const {
  const std::vector<unsigned char> picture = pixels();
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (!file) return std::perror(path.c_str());
  std::fprintf(file, "P6\n%d %d\n255\n", mWidth, mHeight);
  for (int y = mHeight - 1; y >= 0; --y) {
    for (int x = 0; x < mWidth; ++x) std::fwrite(&picture[4 * (size_t(y) * size_t(mWidth) + size_t(x))], 1, 3, file);
  }
  std::fclose(file);
}

}  // namespace rc::bench
