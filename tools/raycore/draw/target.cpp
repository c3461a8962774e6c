// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/target.h"

#include <RC/rc.h>

#include <algorithm>
#include <array>

#include "input/error.h"

namespace rc::tool {
namespace {

struct ErrorName {
  RCenum error;
  const char *name;
};

constexpr std::array kErrorNames{
    ErrorName{RC_INVALID_ENUM, "RC_INVALID_ENUM"},           ErrorName{RC_INVALID_VALUE, "RC_INVALID_VALUE"},
    ErrorName{RC_INVALID_OPERATION, "RC_INVALID_OPERATION"}, ErrorName{RC_STACK_OVERFLOW, "RC_STACK_OVERFLOW"},
    ErrorName{RC_STACK_UNDERFLOW, "RC_STACK_UNDERFLOW"},     ErrorName{RC_OUT_OF_MEMORY, "not enough memory"}};

}  // namespace

Target::Target(int width, int height) {
  constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 8, EGL_NONE};
  constexpr EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  EGLint count = 0;
  mDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  eglInitialize(mDisplay, nullptr, nullptr);
  eglChooseConfig(mDisplay, wanted, &mConfig, 1, &count);
  if (count > 0) mSurface = makeSurface(width, height);
  if (mSurface) mContext = eglCreateContext(mDisplay, mConfig, EGL_NO_CONTEXT, version);
  if (!mContext || !eglMakeCurrent(mDisplay, mSurface, mSurface, mContext)) {
    reject("no picture of {} x {} (EGL error 0x{:04X})", width, height, eglGetError());
  }
  rcViewport(0, 0, width, height);
}

EGLSurface Target::makeSurface(int width, int height) const {
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  return eglCreatePbufferSurface(mDisplay, mConfig, size);
}

void Target::resize(int width, int height) {
  const EGLSurface surface = makeSurface(width, height);
  if (!surface || !eglMakeCurrent(mDisplay, surface, surface, mContext)) {
    reject("no picture of {} x {} (EGL error 0x{:04X})", width, height, eglGetError());
  }
  eglDestroySurface(mDisplay, mSurface);
  mSurface = surface;
}

Target::~Target() {
  eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(mDisplay, mSurface);
  eglDestroyContext(mDisplay, mContext);
  eglTerminate(mDisplay);
}

Image Target::picture(int x, int y, int width, int height) const {
  Image image{"", width, height, std::vector<uint8_t>(size_t(width) * size_t(height) * 4)};
  rcReadPixels(x, y, width, height, RC_RGBA, RC_UNSIGNED_BYTE, image.rgba.data());
  const auto row = [&](int i) { return image.rgba.begin() + std::ptrdiff_t(i) * width * 4; };
  for (int i = 0; i < height / 2; ++i) std::swap_ranges(row(i), row(i + 1), row(height - 1 - i));
  checkErrors("tracing");
  return image;
}

void checkErrors(const char *doing) {
  const RCenum error = rcGetError();
  if (error == RC_NO_ERROR) return;
  const auto known =
      std::find_if(kErrorNames.begin(), kErrorNames.end(), [&](const ErrorName &e) { return e.error == error; });
  reject("{}: {}", doing, known == kErrorNames.end() ? "RayCore failed" : known->name);
}

}  // namespace rc::tool
