// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// target.h: an off-screen picture of RayCore's: EGL display, pbuffer, context.
#pragma once

#include <EGL/egl.h>

#include "scene/scene.h"

namespace rc::tool {

class Target {
 public:
  // Throws InputError if there is no device for it.
  Target(int width, int height);
  ~Target();
  Target(const Target &) = delete;
  Target &operator=(const Target &) = delete;

  // Another size from now on. Throws InputError.
  void resize(int width, int height);

  // Traces what is drawn, if it is not traced yet, and reads it; the first row is the top one.
  Image picture(int width, int height) const { return picture(0, 0, width, height); }
  // A part of it, from the lower left.
  Image picture(int x, int y, int width, int height) const;

 private:
  EGLSurface makeSurface(int width, int height) const;

  EGLDisplay mDisplay = EGL_NO_DISPLAY;
  EGLConfig mConfig = nullptr;
  EGLSurface mSurface = EGL_NO_SURFACE;
  EGLContext mContext = EGL_NO_CONTEXT;
};

// Throws InputError with the name of RayCore's error, if there was one. doing: "drawing the model".
void checkErrors(const char *doing);

}  // namespace rc::tool
