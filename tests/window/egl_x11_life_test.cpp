// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// EGL on X servers: windows, displays and servers that come and go.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <sys/wait.h>
#include <unistd.h>

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

TEST_P(EglX11, AServerThatDiesUnnoticed) {
  const Client client(*mServer);
  const EGLSurface off = client.pbuffer(8, 8);
  ASSERT_TRUE(client.makeCurrent(off));
  mServer.reset();
  EXPECT_TRUE(client.swap(off));
  testing::internal::CaptureStderr();
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_TRUE(eglTerminate(client.display)) << "closes the connection";
  testing::internal::GetCapturedStderr();
}

// Xlib has one handler of errors for the process, and it is the program's, whatever is shown meanwhile.
TEST_P(EglX11, TheProgramsErrorHandlerIsItsOwn) {
  static std::atomic<int> errors = 0;
  errors = 0;
  const auto mine = [](Display *, XErrorEvent *) { return ++errors, 0; };
  const Client client(*mServer);
  const EGLSurface surface = client.surface(client.window(64, 64));
  ASSERT_TRUE(client.makeCurrent(surface));
  XSetErrorHandler(countErrors);
  for (int frame = 1; frame <= 50; ++frame) {
    draw();
    ASSERT_TRUE(eglSwapBuffers(client.display, surface));
    for (int i = 0; i < 10; ++i) {
      const XErrorHandler before = XSetErrorHandler(mine);
      EXPECT_EQ(before, countErrors);
      XDestroyWindow(mServer->connection(), 0x7fffff);
      XSync(mServer->connection(), False);
      XSetErrorHandler(before);
    }
    ASSERT_EQ(errors, 10 * frame);
  }
}

// A child has its parent's socket: what it said there would be nonsense in the middle of the parent's words.
TEST_P(EglX11, ChildrenLeaveTheConnectionAlone) {
  const Client client(*mServer);
  const Window window = client.window(64, 64);
  const EGLSurface surface = client.surface(window);
  ASSERT_TRUE(client.makeCurrent(surface));
  for (int i = 0; i < 20; ++i) {
    draw();
    ASSERT_TRUE(eglSwapBuffers(client.display, surface));
    const pid_t child = fork();
    if (child == 0) {
      alarm(60);
      eglReleaseThread();  // waits for the picture
      eglTerminate(client.display);
      _exit(0);
    }
    for (int k = 0; k < 3; ++k) {
      draw();
      ASSERT_TRUE(eglSwapBuffers(client.display, surface));
    }
    int status = -1;
    waitpid(child, &status, 0);
    ASSERT_EQ(status, 0);
  }
  draw();
  ASSERT_TRUE(client.swap(surface));
  EXPECT_LE(difference(mServer->screenshot(window), traced()), GetParam().rounding);
}

// We are the window manager, and map nothing.
TEST_P(EglX11, AWindowThatIsNeverMapped) {
  XSelectInput(mServer->connection(), DefaultRootWindow(mServer->connection()), SubstructureRedirectMask);
  XSync(mServer->connection(), False);
  const Client client(*mServer);
  const EGLSurface own = client.surface(0);  // the library's own window
  if (!own) GTEST_SKIP() << "the screen's windows have no colours";
  ASSERT_TRUE(client.makeCurrent(own));
  draw();
  EXPECT_TRUE(client.swap(own)) << "seen by nobody";
}

}  // namespace
}  // namespace rc::test
