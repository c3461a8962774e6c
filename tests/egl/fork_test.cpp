// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A program that draws, forks, and goes on in both processes: the child has no threads of the parent's, and draws the
// same pictures with the contexts it was born with, and with new ones.
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "egl/small_program.h"

namespace rc::test {
namespace {

class ForkedProgram : public SmallProgram {
 protected:
  enum class End { AtOnce, WithDestructors };

  // The code with which a child that runs body ends within a minute; 128 and the signal if it was one.
  template <class Body>
  static int inChild(Body &&body, End end = End::AtOnce) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(60);
      const int code = body() ? 0 : 1;
      if (end == End::AtOnce) _exit(code);
      std::exit(code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  // Runs body while so many threads, each with a context and a square surface of its own, call always(surface) over and
  // over.
  template <class Always, class Body>
  void beside(int count, EGLint side, Always &&always, Body &&body) {
    std::atomic<bool> end = false;
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i) {
      threads.emplace_back([&] {
        const EGLSurface surface = pbuffer(side, side);
        ASSERT_TRUE(select({surface, context()}));
        while (!end) always(surface);
        ASSERT_TRUE(eglReleaseThread());
      });
    }
    body();
    end = true;
    for (std::thread &thread : threads) thread.join();
  }
};

TEST_F(ForkedProgram, TheChildDrawsWithTheContextItWasBornWith) {
  ASSERT_TRUE(select(drawable()));
  const Picture before = draw();
  EXPECT_EQ(inChild([&] { return draw() == before && draw() == before; }), 0);
  EXPECT_EQ(draw(), before) << "and so does the parent";
}

TEST_F(ForkedProgram, TheChildMakesContextsOfItsOwn) {
  ASSERT_TRUE(select(drawable()));
  const Picture before = draw();
  EXPECT_EQ(inChild([&] {
              const Drawable own = drawable();
              return select(own) && draw() == before && unselect() && eglDestroyContext(mDisplay, own.context) &&
                     eglDestroySurface(mDisplay, own.surface);
            }),
            0);
}

TEST_F(ForkedProgram, TheChildEndsInOrder) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the child leaves the parent's workers alone on purpose; the sanitizer calls them leaks as it ends";
#endif
  ASSERT_TRUE(select(drawable()));
  const Picture before = draw();
  const auto drawAndTerminate = [&] {
    return draw() == before && unselect() && eglTerminate(mDisplay) && eglReleaseThread();
  };
  EXPECT_EQ(inChild(drawAndTerminate, End::WithDestructors), 0);
  EXPECT_EQ(inChild([] { return true; }, End::WithDestructors), 0) << "with everything still open";
}

TEST_F(ForkedProgram, OtherThreadsMayDrawMeanwhile) {
  ASSERT_TRUE(select(drawable()));
  const Picture before = draw();
  const auto drawAgain = [&](EGLSurface) { EXPECT_EQ(draw(), before); };
  beside(2, kSide, drawAgain, [&] {
    for (int i = 0; i < 10; ++i) EXPECT_EQ(inChild([&] { return draw() == before; }), 0);
  });
}

// They leave no moment in which none of them is in a call: fork() would wait for ever.
TEST_F(ForkedProgram, OthersWhoNeverPauseLetItPass) {
  ASSERT_TRUE(select(drawable()));
  const Picture before = draw();
  const auto swapAgain = [&](EGLSurface surface) { eglSwapBuffers(mDisplay, surface); };
  beside(3, 300, swapAgain, [&] {
    for (int i = 0; i < 20; ++i) EXPECT_EQ(inChild([&] { return draw() == before; }), 0);
  });
}

// main() returns while they draw.
TEST_F(ForkedProgram, EndsThoughOtherThreadsDraw) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "what they have is a leak to the sanitizer";
#endif
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the sanitizer does not know that the locks of a child are new ones, and here it has threads";
#endif
  for (int i = 0; i < 20; ++i) {
    const auto drawForEver = [&] {
      std::atomic<int> frames = 0;
      for (int k = 0; k < 2; ++k) {
        std::thread([&] {
          const EGLSurface surface = pbuffer(64, 64);
          if (!select({surface, context()})) return;
          for (;; ++frames) {
            draw();
            eglSwapBuffers(mDisplay, surface);
          }
        }).detach();
      }
      while (frames < 4) usleep(100);
      std::exit(0);
      return false;
    };
    EXPECT_EQ(inChild(drawForEver), 0);
  }
}

}  // namespace
}  // namespace rc::test
