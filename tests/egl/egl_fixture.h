// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// egl_fixture.h: an initialised display without a window system, and what tests make on it.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <gtest/gtest.h>

#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "egl/thread.h"

namespace rc::test {

inline void *const kNothing = reinterpret_cast<void *>(0x7fffffff);  // no handle is so large

// The picture is the surface's, and its window shows it, when it returns.
inline bool swapAndWait(EGLDisplay display, EGLSurface surface) {
  const EGLBoolean swapped = eglSwapBuffers(display, surface);
  egl::threadState().awaitPicture();
  return swapped == EGL_TRUE;
}

class Egl : public testing::Test {
 protected:
  void SetUp() override {
    mDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_TRUE(eglInitialize(mDisplay, nullptr, nullptr));
    mConfig = choose({EGL_RED_SIZE, 8});
    ASSERT_TRUE(mConfig);
  }
  void TearDown() override {
    eglReleaseThread();
    eglTerminate(mDisplay);
    eglGetError();
  }

  // The best config for a list without its end.
  EGLConfig choose(std::vector<EGLint> list) {
    list.push_back(EGL_NONE);
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(mDisplay, list.data(), &config, 1, &count);
    return count == 1 ? config : nullptr;
  }
  EGLint valueOf(EGLConfig config, EGLint name) {
    EGLint value = -1;
    EXPECT_TRUE(eglGetConfigAttrib(mDisplay, config, name, &value));
    return value;
  }
  EGLSurface pbufferOf(EGLConfig config, std::vector<EGLint> list) {
    list.push_back(EGL_NONE);
    return eglCreatePbufferSurface(mDisplay, config, list.data());
  }
  EGLSurface pbuffer(EGLint width = 32, EGLint height = 16) {
    return pbufferOf(mConfig, {EGL_WIDTH, width, EGL_HEIGHT, height});
  }
  EGLContext context(EGLConfig config = nullptr) {
    const EGLint version1[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
    return eglCreateContext(mDisplay, config ? config : mConfig, EGL_NO_CONTEXT, version1);
  }
  EGLint query(EGLSurface surface, EGLint name, EGLint untouched = -77) {
    EGLint value = untouched;
    EXPECT_TRUE(eglQuerySurface(mDisplay, surface, name, &value)) << name;
    return value;
  }
  void expectError(EGLint error) { EXPECT_EQ(eglGetError(), error); }

  EGLDisplay mDisplay = EGL_NO_DISPLAY;
  EGLConfig mConfig = nullptr;
};

}  // namespace rc::test
