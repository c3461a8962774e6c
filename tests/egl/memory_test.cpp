// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Calls that run out of memory, at each allocation in turn: EGL_BAD_ALLOC, and nothing has changed. [EGL 1.5, 3.1]
#include <functional>

#include "RC/rc.h"
#include "api/allocation_failure.h"
#include "api/context.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

class Memory : public Egl {
 protected:
  // Calls until no allocation fails; the number of those that did. `unchanged` is asked after each failure.
  int starve(const std::function<bool()> &call, const std::function<void()> &unchanged) {
    for (int good = 0; good < 1000; ++good) {
      failAllocationAfter(good);
      const bool done = call();
      const bool failed = allocationFailed();
      const EGLint error = eglGetError();
      if (done) {
        EXPECT_FALSE(failed) << "a success without its memory";
        EXPECT_EQ(error, EGL_SUCCESS);
        return good;
      }
      EXPECT_TRUE(failed);
      EXPECT_EQ(error, EGL_BAD_ALLOC);
      unchanged();
    }
    ADD_FAILURE() << "it never succeeds";
    return 0;
  }
};

TEST_F(Memory, WhatWasCurrentStaysCurrent) {
  const EGLSurface before = pbuffer(32, 16), after = pbuffer(64, 64);
  const EGLContext first = context(), second = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, before, before, first));
  const api::Context *current = api::currentContext();
  const auto unchanged = [&] {
    EXPECT_EQ(eglGetCurrentContext(), first);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), before);
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), before);
    EXPECT_EQ(api::currentContext(), current);
    rcClearColor(1, 0, 0, 1);
    EXPECT_TRUE(swapAndWait(mDisplay, before));
  };
  EXPECT_GT(starve([&] { return eglMakeCurrent(mDisplay, after, after, second) == EGL_TRUE; }, unchanged), 0);
  EXPECT_EQ(eglGetCurrentContext(), second);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_TRUE(eglMakeCurrent(mDisplay, before, before, first)) << "neither is current anywhere";
}

TEST_F(Memory, WhatIsMadeIsMadeOrNot) {
  const EGLSurface target = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, target, target, made));
  const EGLSurface source = pbufferOf(mConfig, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB,
                                                EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  rcBindTexture(RC_TEXTURE_2D, 5);
  const auto texture = api::currentContext()->objects().textures.find(5);
  EGLint count = 0;
  EXPECT_GT(starve([&] { return context() != EGL_NO_CONTEXT; }, [] {}), 0);
  EXPECT_GT(starve([&] { return eglCreatePbufferSurface(mDisplay, mConfig, nullptr) != EGL_NO_SURFACE; }, [] {}), 0);
  EXPECT_GT(starve([&] { return eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr) != EGL_NO_SYNC; }, [] {}), 0);
  EXPECT_GT(starve([&] { return eglChooseConfig(mDisplay, nullptr, nullptr, 0, &count) == EGL_TRUE; },
                   [&] { EXPECT_EQ(count, 0); }),
            0);
  EXPECT_GT(starve([&] { return eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER) == EGL_TRUE; },
                   [&] { EXPECT_FALSE(texture->loaded()); }),
            0);
  EXPECT_TRUE(texture->loaded());
  EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER));
}

}  // namespace
}  // namespace rc::test
