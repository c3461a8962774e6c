// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shortage_program.h: a program that uses some of everything: EGL, textures, buffer objects, a static scene, moving
// geometry over several frames, reading the picture. It allocates nothing itself, so that all that fails is ours.
#pragma once

#include <EGL/egl.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "RC/rc.h"

namespace rc::test {

inline constexpr int kShortageSide = 16;

struct ShortageScene {
  RCenum structure;
  bool large;  // so much moves that it is sorted along a curve
};

class ShortageProgram {
 public:
  using Picture = std::array<uint32_t, std::size_t(kShortageSide) * kShortageSide>;

  explicit ShortageProgram(const ShortageScene &scene) : mScene(scene) {}

  // EGL up to a current context; false as soon as a call fails. Then error() is its error.
  bool open();
  // Everything up to the picture; goes on whatever fails.
  void draw();
  void close();

  EGLint error() const { return mEglError; }
  // Calls of draw() that raised RC_OUT_OF_MEMORY, or EGL_BAD_ALLOC; and those that raised something else.
  int shortages() const { return mShortages; }
  RCenum otherError() const { return mOther; }
  const Picture &picture() const { return mPicture; }

 private:
  bool failed(bool succeeded);
  void note();
  void resetState();
  void loadTextures();
  void loadBuffers();
  void drawStatics();
  void drawFrame(int frame);

  ShortageScene mScene;
  EGLDisplay mDisplay = EGL_NO_DISPLAY;
  EGLSurface mSurface = EGL_NO_SURFACE;
  EGLContext mContext = EGL_NO_CONTEXT;
  EGLint mEglError = EGL_SUCCESS;
  int mShortages = 0;
  RCenum mOther = RC_NO_ERROR;
  Picture mPicture{};
};

}  // namespace rc::test
