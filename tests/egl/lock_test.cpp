// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// While one context traces, EGL goes on for everybody else: even contexts that share its objects become current, and a
// call that does have to wait holds nobody up. [egl/display.h]
#include <chrono>
#include <future>
#include <optional>
#include <thread>

#include "RC/rc.h"
#include "egl/egl_fixture.h"
#include "egl/thread.h"

namespace rc::test {
namespace {

using namespace std::chrono_literals;

// What holds the lock of a share group, as a trace that goes on and on does.
class Trace {
 public:
  Trace(EGLDisplay display, EGLContext context) : mLock(mutexOf(display, context)) {}
  void end() {
    if (mLock.owns_lock()) mLock.unlock();
  }

 private:
  static ForkMutex &mutexOf(EGLDisplay display, EGLContext context) {
    return egl::findDisplay(display)->contexts.find(context)->api.objects().mutex;
  }
  std::unique_lock<ForkMutex> mLock;
};

class Locks : public Egl {
 protected:
  // Whether a call on another thread ends though the trace goes on. The time matters to a failure alone.
  template <class Call>
  bool ends(Call &&call) {
    auto answer = std::async(std::launch::async, call);
    if (answer.wait_for(60s) == std::future_status::ready) return answer.get();
    mTrace->end();
    return false;
  }

  EGLSurface mSurface = nullptr;
  EGLContext mFirst = nullptr, mSharing = nullptr;
  std::optional<Trace> mTrace;

  void SetUp() override {
    Egl::SetUp();
    mSurface = pbufferOf(mConfig, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB,
                                   EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
    mFirst = context();
    mSharing = eglCreateContext(mDisplay, mConfig, mFirst, nullptr);
    ASSERT_TRUE(mSurface && mSharing);
  }
  void TearDown() override {
    mTrace.reset();
    Egl::TearDown();
  }
};

TEST_F(Locks, ASharingContextBecomesCurrent) {
  mTrace.emplace(mDisplay, mFirst);
  EXPECT_TRUE(ends([&] {
    const bool done = eglMakeCurrent(mDisplay, mSurface, mSurface, mSharing);
    const EGLSync sync = eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr);
    return done && sync && eglMakeCurrent(mDisplay, nullptr, nullptr, nullptr);
  }));
  EXPECT_TRUE(ends([&] { return eglCreateContext(mDisplay, mConfig, mFirst, nullptr) != EGL_NO_CONTEXT; }));
}

TEST_F(Locks, WhoWaitsForATextureHoldsNobodyUp) {
  mTrace.emplace(mDisplay, mFirst);
  std::promise<void> started;
  std::thread waits([&] {
    ASSERT_TRUE(eglMakeCurrent(mDisplay, mSurface, mSurface, mSharing));
    started.set_value();
    EXPECT_TRUE(eglBindTexImage(mDisplay, mSurface, EGL_BACK_BUFFER));
    EXPECT_FALSE(eglCreateImage(mDisplay, mSharing, EGL_GL_TEXTURE_2D, EGLClientBuffer(99), nullptr));
    EXPECT_TRUE(eglReleaseTexImage(mDisplay, mSurface, EGL_BACK_BUFFER));
  });
  started.get_future().wait();
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(ends([&] { return query(mSurface, EGL_WIDTH) == 16; }));
  }
  mTrace->end();
  waits.join();
}

}  // namespace
}  // namespace rc::test
