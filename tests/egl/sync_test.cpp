// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Fences: when they are passed, and who waits for whom. [EGL 1.5, 3.8.1]
#include <atomic>
#include <thread>

#include "RC/rc.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

class Syncs : public Egl {
 protected:
  EGLSync fence() { return eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr); }
  EGLAttrib attribute(EGLSync sync, EGLint name) {
    EGLAttrib value = -1;
    EXPECT_TRUE(eglGetSyncAttrib(mDisplay, sync, name, &value));
    return value;
  }
  bool passed(EGLSync sync) { return attribute(sync, EGL_SYNC_STATUS) == EGL_SIGNALED; }
  void makeCurrent() {
    mSurface = pbuffer();
    ASSERT_TRUE(eglMakeCurrent(mDisplay, mSurface, mSurface, context()));
  }

  EGLSurface mSurface = nullptr;
};

TEST_F(Syncs, AFenceIsPassedWhenThePictureIsTraced) {
  makeCurrent();
  const EGLSync sync = fence();
  ASSERT_TRUE(sync);
  EXPECT_EQ(attribute(sync, EGL_SYNC_TYPE), EGL_SYNC_FENCE);
  EXPECT_EQ(attribute(sync, EGL_SYNC_CONDITION), EGL_SYNC_PRIOR_COMMANDS_COMPLETE);
  EXPECT_FALSE(passed(sync));
  EXPECT_EQ(eglClientWaitSync(mDisplay, sync, 0, 0), EGL_TIMEOUT_EXPIRED) << "a look";
  rcFinish();
  EXPECT_TRUE(passed(sync));
  EXPECT_EQ(eglClientWaitSync(mDisplay, sync, 0, 0), EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(passed(fence())) << "nothing is left to do";
  rcClearColor(1, 0, 0, 1);
  const EGLSync next = fence();
  EXPECT_FALSE(passed(next));
  EXPECT_TRUE(swapAndWait(mDisplay, mSurface));
  EXPECT_TRUE(passed(next));
  EXPECT_TRUE(eglDestroySync(mDisplay, sync));
  EXPECT_FALSE(eglDestroySync(mDisplay, sync));
  expectError(EGL_BAD_PARAMETER);
}

TEST_F(Syncs, WaitingForOnesOwnPictureHasItTraced) {
  makeCurrent();
  const EGLSync first = fence();
  EXPECT_EQ(eglClientWaitSync(mDisplay, first, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
  rcClearColor(1, 0, 0, 1);
  const EGLSync second = fence();
  EXPECT_EQ(eglClientWaitSync(mDisplay, second, EGL_SYNC_FLUSH_COMMANDS_BIT, 0), EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(eglWaitSync(mDisplay, second, 0));
}

TEST_F(Syncs, AnotherThreadWaits) {
  makeCurrent();
  const EGLSync sync = fence();
  std::atomic<int> done = 0;
  std::thread client([&] {
    EXPECT_EQ(eglClientWaitSync(mDisplay, sync, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    ++done;
  });
  std::thread server([&] {
    const EGLSurface surface = pbuffer();
    ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
    EXPECT_TRUE(eglWaitSync(mDisplay, sync, 0));
    ++done;
  });
  std::thread impatient([&] { EXPECT_EQ(eglClientWaitSync(mDisplay, sync, 0, 1000), EGL_TIMEOUT_EXPIRED); });
  impatient.join();
  EXPECT_EQ(done, 0);
  rcFinish();
  client.join();
  server.join();
  EXPECT_EQ(done, 2);
}

TEST_F(Syncs, NobodyWaitsForAContextThatIsReleased) {
  makeCurrent();
  const EGLSync sync = fence();
  ASSERT_TRUE(eglReleaseThread());
  EXPECT_TRUE(passed(sync));
}

TEST_F(Syncs, ADestroyedFenceIsPassedAllTheSame) {
  makeCurrent();
  const EGLSync sync = fence();
  std::atomic<bool> waiting = false;
  std::thread client([&] {
    waiting = true;
    const EGLint answer = eglClientWaitSync(mDisplay, sync, 0, EGL_FOREVER);
    EXPECT_TRUE(answer == EGL_CONDITION_SATISFIED || answer == EGL_FALSE);  // FALSE: it came too late
  });
  while (!waiting) std::this_thread::yield();
  EXPECT_TRUE(eglDestroySync(mDisplay, sync));
  rcFinish();
  client.join();
}

TEST_F(Syncs, WithoutSurfacesThereIsNothingToWaitFor) {
  ASSERT_TRUE(eglMakeCurrent(mDisplay, nullptr, nullptr, context()));
  EXPECT_TRUE(passed(fence()));
}

TEST_F(Syncs, TheExtensionsTwins) {
  makeCurrent();
  const auto create = reinterpret_cast<PFNEGLCREATESYNCKHRPROC>(eglGetProcAddress("eglCreateSyncKHR"));
  const auto get = reinterpret_cast<PFNEGLGETSYNCATTRIBKHRPROC>(eglGetProcAddress("eglGetSyncAttribKHR"));
  const auto wait = reinterpret_cast<PFNEGLWAITSYNCKHRPROC>(eglGetProcAddress("eglWaitSyncKHR"));
  EXPECT_FALSE(create(mDisplay, 0x7777, nullptr));
  expectError(EGL_BAD_ATTRIBUTE);
  const EGLSyncKHR sync = create(mDisplay, EGL_SYNC_FENCE_KHR, nullptr);
  EGLint value = 0;
  EXPECT_TRUE(get(mDisplay, sync, EGL_SYNC_STATUS_KHR, &value));
  EXPECT_EQ(value, EGL_UNSIGNALED_KHR);
  EXPECT_EQ(wait(mDisplay, sync, 0), EGL_TRUE);
}

}  // namespace
}  // namespace rc::test
