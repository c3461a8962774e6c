// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Eight threads make contexts current, draw and look at what they drew; some share objects, all share a few contexts.
#include <atomic>
#include <thread>

#include "RC/rcu.h"
#include "egl/egl_fixture.h"
#include "egl/thread.h"

namespace rc::test {
namespace {

constexpr int kThreads = 8, kFrames = 12;

class Threads : public Egl {
 protected:
  // Clears to a colour of the thread, draws a triangle in the lower left, swaps, and reads both.
  void drawAndLook(int thread, int frame, EGLSurface surface) {
    const auto level = RCubyte(20 * thread + frame);
    static const float vertices[] = {-1, -1, -1.5f, 0, -1, -1.5f, -1, 0, -1.5f};
    const float white[] = {1, 1, 1, 1};
    rcClearColor(0, 0, (float(level) + 0.5f) / 256, 1);
    rcMatrixMode(RC_PROJECTION);
    rcLoadIdentity();
    rcFrustumf(-1, 1, -1, 1, 1, 10);
    rcMatrixMode(RC_MODELVIEW);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, white);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcDrawArrays(RC_TRIANGLES, 0, 3);
    ASSERT_TRUE(swapAndWait(mDisplay, surface));
    const hal::Target picture = egl::threadState().current.draw->picture();
    EXPECT_EQ(picture.pixels[picture.width - 1], 0xff000000u | uint32_t(level) << 16);
    EXPECT_EQ(picture.pixels[picture.width * (picture.height - 5) + 4], 0xffffffffu);
  }
};

TEST_F(Threads, EightDrawAtOnce) {
  const EGLContext first = context();
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      // Every other context is of one share group.
      const EGLContext own = eglCreateContext(mDisplay, mConfig, i % 2 ? first : EGL_NO_CONTEXT, nullptr);
      const EGLSurface surface = pbuffer(16, 16);
      for (int frame = 0; frame < kFrames; ++frame) {
        ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, own));
        drawAndLook(i, frame, surface);
        ASSERT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
      }
      EXPECT_TRUE(eglDestroySurface(mDisplay, surface));
      EXPECT_TRUE(eglDestroyContext(mDisplay, own));
    });
  }
  for (std::thread &thread : threads) thread.join();
}

TEST_F(Threads, ContextsGoFromThreadToThread) {
  EGLContext contexts[3] = {context(), context(), context()};
  std::atomic<int> drawn = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      const EGLSurface surface = pbuffer(16, 16);
      for (int frame = 0; frame < kFrames; ++frame) {
        const EGLContext wanted = contexts[(i + frame) % 3];
        while (!eglMakeCurrent(mDisplay, surface, surface, wanted)) {
          ASSERT_EQ(eglGetError(), EGL_BAD_ACCESS);
          std::this_thread::yield();
        }
        drawAndLook(i, frame, surface);
        EXPECT_TRUE(eglReleaseThread());
        ++drawn;
      }
    });
  }
  for (std::thread &thread : threads) thread.join();
  EXPECT_EQ(drawn, kThreads * kFrames);
}

// One pbuffer, in and out of textures of a share group that others load and trace.
TEST_F(Threads, APbufferBetweenTextures) {
  const EGLContext first = context();
  const EGLSurface source = pbufferOf(mConfig, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB,
                                                EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  const std::vector<RCubyte> texels(16 * 16 * 3, 100);
  std::atomic<int> bound = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      const EGLContext own = eglCreateContext(mDisplay, mConfig, i % 4 ? first : EGL_NO_CONTEXT, nullptr);
      const EGLSurface surface = pbuffer(16, 16);
      ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, own));
      for (int frame = 0; frame < kFrames; ++frame) {
        rcBindTexture(RC_TEXTURE_2D, RCuint(1 + i % 2));
        if (eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER)) {
          ++bound;
        } else {
          ASSERT_EQ(eglGetError(), EGL_BAD_ACCESS);
        }
        const EGLImage image =
            eglCreateImage(mDisplay, own, EGL_GL_TEXTURE_2D, EGLClientBuffer(uintptr_t(2 - i % 2)), nullptr);
        EXPECT_TRUE(!image || eglDestroyImage(mDisplay, image));
        if (frame % 3 == i % 3) {
          rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
        }
        rcFinish();
        EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER));
      }
      EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
      EXPECT_TRUE(eglReleaseThread());
    });
  }
  for (std::thread &thread : threads) thread.join();
  EXPECT_GT(bound, 0);
}

TEST_F(Threads, QueriesWhileOthersDraw) {
  const EGLSurface surface = pbuffer(16, 16);
  const EGLContext made = context();
  std::atomic<bool> done = false;
  std::thread painter([&] {
    ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
    for (int frame = 0; frame < kFrames; ++frame) drawAndLook(1, frame, surface);
    eglReleaseThread();
    done = true;
  });
  do {
    EXPECT_EQ(query(surface, EGL_WIDTH), 16);
    EGLint value = 0;
    EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
    EXPECT_EQ(value, EGL_NONE) << "not current here";
  } while (!done);
  painter.join();
}

}  // namespace
}  // namespace rc::test
