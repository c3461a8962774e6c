// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// egl_x11_fixture.h: EGL on X servers of several depths, with a context, windows and pictures.
#pragma once

#include <EGL/egl.h>
#include <gtest/gtest.h>

#include "egl/egl_fixture.h"
#include "window/x11_fixture.h"

namespace rc::test {

// A display of EGL on a server, with a context, and windows of the program's own connection.
class Client {
 public:
  explicit Client(const XServer &server, std::vector<EGLint> wanted = {EGL_RED_SIZE, 8}) : mServer(server) {
    display = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, server.connection(), nullptr);
    EXPECT_TRUE(eglInitialize(display, nullptr, nullptr));
    wanted.push_back(EGL_NONE);
    EGLint count = 0;
    EXPECT_TRUE(eglChooseConfig(display, wanted.data(), &config, 1, &count) && count == 1);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  }
  ~Client() {
    eglReleaseThread();
    eglTerminate(display);
  }
  Client(const Client &) = delete;
  Client &operator=(const Client &) = delete;

  Window window(unsigned width, unsigned height, int left = 0) const {
    Display *x = mServer.connection();
    const Window made = XCreateSimpleWindow(x, DefaultRootWindow(x), left, 0, width, height, 0, 0, 0);
    XSelectInput(x, made, StructureNotifyMask);
    XMapWindow(x, made);
    XEvent event;
    do {
      XWindowEvent(x, made, StructureNotifyMask, &event);
    } while (event.type != MapNotify);
    return made;
  }
  EGLSurface surface(Window native) const { return eglCreateWindowSurface(display, config, native, nullptr); }
  EGLSurface pbuffer(EGLint width, EGLint height) const {
    const EGLint list[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    return eglCreatePbufferSurface(display, config, list);
  }
  bool makeCurrent(EGLSurface draw) const { return eglMakeCurrent(display, draw, draw, context) == EGL_TRUE; }
  bool swap(EGLSurface draw) const { return swapAndWait(display, draw); }

  EGLDisplay display;
  EGLConfig config = nullptr;
  EGLContext context;

 private:
  const XServer &mServer;
};

// A triangle under a light, so that there are many colours; the same in every frame and at every size.
void draw();

// What the library traced last for the current surface.
Picture traced();

// The largest difference of a channel; 256 for pictures of different sizes or without contents.
int difference(const Picture &a, const Picture &b);

// The program's handler of X errors, which must not be called.
int countErrors(Display *, XErrorEvent *);

struct Screen {
  const char *name;
  std::vector<std::string> options;
  int rounding;  // what its depth leaves of 255
};

void PrintTo(const Screen &screen, std::ostream *out);

class EglX11 : public testing::TestWithParam<Screen> {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::optional<XServer> mServer;
};

}  // namespace rc::test
