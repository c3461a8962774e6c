// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// EGL on X servers: windows, displays and servers that come and go.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <atomic>
#include <thread>

#include "RC/rcu.h"
#include "window/egl_x11_fixture.h"

namespace rc::test {
namespace {

// Nobody is held up by a window that does not come. [egl/display.h]
TEST_P(EglX11, OthersGoOnWhileAWindowIsWaitedFor) {
  const Client client(*mServer);
  const EGLSurface off = client.pbuffer(8, 8);
  std::atomic<bool> done = false;
  std::thread waits([&] {
    EXPECT_FALSE(client.surface(0x7fffff));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    done = true;
  });
  int calls = 0;
  for (EGLint value = 0; !done; ++calls) EXPECT_TRUE(eglQuerySurface(client.display, off, EGL_WIDTH, &value));
  waits.join();
  EXPECT_GT(calls, 20) << "they came one by one";
}

// The next connection may be at the address of one that was closed.
TEST_P(EglX11, AClosedDisplayIsNotTheNextOne) {
  const auto open = [&] { return XOpenDisplay(mServer->name().c_str()); };
  std::vector<EGLDisplay> seen;
  for (int round = 0; round < 4; ++round) {
    Display *x = open();
    ASSERT_TRUE(x);
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x, nullptr);
    ASSERT_EQ(std::count(seen.begin(), seen.end(), display), 0) << "a display of before";
    seen.push_back(display);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    EXPECT_EQ(eglGetDisplay(x), display);
    EXPECT_TRUE(round % 2 == 0 || eglTerminate(display));
    XCloseDisplay(x);
    EXPECT_NE(eglGetDisplay(x), display) << "whatever is there now is another one";
    // The old display works on, over its own connection, until it ends; then there is nothing to connect to.
    EGLint count = 0;
    EXPECT_EQ(eglGetConfigs(display, nullptr, 0, &count), EGLBoolean(round % 2 == 0));
    EXPECT_TRUE(eglTerminate(display));
    EXPECT_FALSE(eglInitialize(display, nullptr, nullptr));
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
  }
}

TEST_P(EglX11, AWindowDestroyedUnderUs) {
  const Client client(*mServer);
  const Window window = client.window(64, 64), other = client.window(64, 64);
  const EGLSurface surface = client.surface(window), second = client.surface(other);
  EXPECT_FALSE(client.surface(window)) << "it has a surface";
  EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
  ASSERT_TRUE(client.makeCurrent(surface));
  ASSERT_TRUE(client.swap(surface));
  XDestroyWindow(mServer->connection(), window);
  XSync(mServer->connection(), False);
  for (int i = 0; i < 3; ++i) {
    draw();
    EXPECT_FALSE(client.swap(surface));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  }
  EXPECT_FALSE(eglWaitClient());
  EXPECT_EQ(eglGetError(), EGL_BAD_CURRENT_SURFACE);
  EXPECT_TRUE(client.makeCurrent(second));
  EXPECT_TRUE(client.swap(second));
  EXPECT_FALSE(client.makeCurrent(surface));
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  EXPECT_TRUE(eglDestroySurface(client.display, surface));
  EXPECT_FALSE(client.surface(window));
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
}

TEST_P(EglX11, SeveralWindowsOnSeveralServers) {
  XServer another({"-screen", "0", "320x240x16"});
  ASSERT_TRUE(another.connection());
  XSetErrorHandler(countErrors);
  const Client here(*mServer), there(another);
  EXPECT_NE(here.display, there.display);
  const Window windows[] = {here.window(40, 30), here.window(60, 50, 100)}, far = there.window(70, 20);
  const EGLSurface surfaces[] = {here.surface(windows[0]), here.surface(windows[1])}, farSurface = there.surface(far);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 2; ++i) {
      ASSERT_TRUE(here.makeCurrent(surfaces[i]));
      draw();
      ASSERT_TRUE(here.swap(surfaces[i]));
      EXPECT_LE(difference(mServer->screenshot(windows[i]), traced()), GetParam().rounding);
    }
    ASSERT_TRUE(there.makeCurrent(farSurface));
    draw();
    ASSERT_TRUE(there.swap(farSurface));
    EXPECT_LE(difference(another.screenshot(far), traced()), 8);
  }
}

TEST_P(EglX11, AServerThatDies) {
  const Client client(*mServer);
  const EGLSurface surface = client.surface(client.window(64, 64)), off = client.pbuffer(8, 8);
  ASSERT_TRUE(client.makeCurrent(surface));
  ASSERT_TRUE(client.swap(surface));
  mServer.reset();
  testing::internal::CaptureStderr();
  EXPECT_FALSE(client.swap(surface));
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("X server has gone"), std::string::npos);
  EXPECT_FALSE(client.swap(surface)) << "and again";
  ASSERT_TRUE(client.makeCurrent(off)) << "pbuffers live on";
  EXPECT_TRUE(client.swap(off));
  EXPECT_TRUE(eglDestroySurface(client.display, surface));
}

}  // namespace
}  // namespace rc::test
