// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// EGL on X servers of several depths: windows and pixmaps show what a pbuffer holds, follow sizes, and come and go.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <random>
#include <thread>

#include "RC/rcu.h"
#include "egl/egl_fixture.h"
#include "window/x11_fixture.h"

// After what Xlib's macros would be in the way of.
#include <X11/Xutil.h>

namespace rc::test {
namespace {

int gErrors = 0;
int countErrors(Display *, XErrorEvent *) { return ++gErrors; }

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

// A window or pixmap that the library is told to draw to.
Window otherWindow(Display *x, const XVisualInfo &info, unsigned kind) {
  XSetWindowAttributes attributes{};
  const bool shown = kind == InputOutput;
  if (shown) attributes.colormap = XCreateColormap(x, DefaultRootWindow(x), info.visual, AllocNone);
  const Window window = XCreateWindow(x, DefaultRootWindow(x), 0, 0, 64, 48, 0, shown ? info.depth : 0, kind,
                                      info.visual, shown ? CWColormap | CWBorderPixel : 0, &attributes);
  XSync(x, False);
  return window;
}

// A triangle under a light, so that there are many colours; the same in every frame and at every size.
void draw() {
  RCint viewport[4];
  rcGetIntegerv(RC_VIEWPORT, viewport);
  static const float vertices[] = {-2, -1, -1.5f, 2, -1, -3, 0, 2, -2}, light[] = {0.5f, 0.5f, 0, 1};
  rcClearColor(0.3f, 0.6f, 0.9f, 1);
  rcMatrixMode(RC_PROJECTION);
  rcLoadIdentity();
  rcFrustumf(-1, 1, -1, 1, 1, 10);
  rcMatrixMode(RC_MODELVIEW);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, light);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
}

// What the library traced last for the current surface.
Picture traced() {
  const hal::Target target = egl::threadState().current.draw->picture();
  Picture picture{target.width, target.height, {}};
  for (int i = 0; i < target.width * target.height; ++i) {
    for (int shift = 0; shift < 24; shift += 8) picture.rgb.push_back(uint8_t(target.pixels[i] >> shift));
  }
  return picture;
}

// The largest difference of a channel; 256 for pictures of different sizes or without contents.
int difference(const Picture &a, const Picture &b) {
  if (a.rgb.empty() || a.width != b.width || a.height != b.height) return 256;
  int largest = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
  return largest;
}

struct Screen {
  const char *name;
  std::vector<std::string> options;
  int rounding;  // what its depth leaves of 255
};

void PrintTo(const Screen &screen, std::ostream *out) { *out << screen.name; }

class EglX11 : public testing::TestWithParam<Screen> {
 protected:
  void SetUp() override {
    if (!XServer::available()) GTEST_SKIP() << "Xvfb is not installed; scripts/setup.sh does it";
    mServer.emplace(GetParam().options);
    ASSERT_TRUE(mServer->connection());
    XSetErrorHandler(countErrors);
    gErrors = 0;
  }
  void TearDown() override { EXPECT_EQ(gErrors, 0) << "an error of X reached the program"; }

  std::optional<XServer> mServer;
};

TEST_P(EglX11, AWindowShowsWhatAPbufferHolds) {
  const Client client(*mServer);
  const Window window = client.window(160, 120);
  ASSERT_TRUE(client.makeCurrent(client.pbuffer(160, 120)));
  draw();
  rcFinish();
  const Picture reference = traced();
  const EGLSurface surface = client.surface(window);
  ASSERT_TRUE(client.makeCurrent(surface));
  draw();
  ASSERT_TRUE(client.swap(surface));
  EXPECT_EQ(difference(traced(), reference), 0);
  EXPECT_LE(difference(mServer->screenshot(window), reference), GetParam().rounding);
  EGLint value = 0;
  EXPECT_TRUE(eglGetConfigAttrib(client.display, client.config, EGL_NATIVE_VISUAL_ID, &value));
  Display *x = mServer->connection();
  EXPECT_EQ(VisualID(value), XVisualIDFromVisual(DefaultVisual(x, DefaultScreen(x))));
}

TEST_P(EglX11, AWindowOfAnotherVisual) {
  Display *x = mServer->connection();
  XVisualInfo info;
  if (!XMatchVisualInfo(x, DefaultScreen(x), 32, TrueColor, &info)) GTEST_SKIP() << "the server has no depth 32";
  const Client client(*mServer);
  const Window window = otherWindow(x, info, InputOutput);
  XMapWindow(x, window);
  XSync(x, False);
  const EGLSurface surface = client.surface(window);
  ASSERT_TRUE(client.makeCurrent(surface));
  draw();
  ASSERT_TRUE(client.swap(surface));
  ASSERT_TRUE(
      eventually([&] { return client.swap(surface) && difference(mServer->screenshot(window), traced()) == 0; }));
  XImage *image = XGetImage(x, window, 1, 1, 1, 1, AllPlanes, ZPixmap);
  ASSERT_TRUE(image);
  EXPECT_EQ(XGetPixel(image, 0, 0) >> 24, 255u) << "opaque to a compositor";
  XDestroyImage(image);
}

TEST_P(EglX11, PixmapsHoldThePictureOnceItIsTraced) {
  const Client client(*mServer);
  Display *x = mServer->connection();
  const auto depth = unsigned(DefaultDepth(x, DefaultScreen(x)));
  const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 80, 60, depth);
  const Pixmap copy = XCreatePixmap(x, DefaultRootWindow(x), 80, 60, depth);
  const Pixmap bitmap = XCreatePixmap(x, DefaultRootWindow(x), 80, 60, 1);
  XSync(x, False);
  const EGLSurface surface = eglCreatePixmapSurface(client.display, client.config, pixmap, nullptr);
  ASSERT_TRUE(surface);
  EGLint value = 0;
  EXPECT_TRUE(eglQuerySurface(client.display, surface, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_SINGLE_BUFFER);
  ASSERT_TRUE(client.makeCurrent(surface));
  draw();
  EXPECT_TRUE(eglWaitClient());
  // A window stands in for the pixmap: that is what the fixture takes pictures of.
  const Window window = client.window(80, 60);
  const auto shown = [&](Pixmap source) {
    XCopyArea(x, source, window, DefaultGC(x, DefaultScreen(x)), 0, 0, 80, 60, 0, 0);
    return mServer->screenshot(window);
  };
  EXPECT_LE(difference(shown(pixmap), traced()), GetParam().rounding);
  EXPECT_TRUE(eglCopyBuffers(client.display, surface, copy));
  EXPECT_LE(difference(shown(copy), traced()), GetParam().rounding);

  EXPECT_FALSE(eglCreatePixmapSurface(client.display, client.config, pixmap, nullptr)) << "it has one";
  EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
  EXPECT_FALSE(eglCreatePixmapSurface(client.display, client.config, bitmap, nullptr)) << "it has no colours";
  EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
  EXPECT_FALSE(eglCreatePixmapSurface(client.display, client.config, window, nullptr)) << "a window";
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
  EXPECT_FALSE(eglCopyBuffers(client.display, surface, 0x7fffff));
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
  EXPECT_FALSE(eglCopyBuffers(client.display, surface, bitmap));
  EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
  const auto matching = [&](Pixmap wanted) {
    const EGLint list[] = {EGL_MATCH_NATIVE_PIXMAP, EGLint(wanted), EGL_NONE};
    EGLint count = -1;
    EXPECT_TRUE(eglChooseConfig(client.display, list, nullptr, 0, &count));
    return count;
  };
  EXPECT_EQ(matching(copy), 36);
  EXPECT_EQ(matching(bitmap), 0);
  EXPECT_TRUE(eglCreatePlatformPixmapSurface(client.display, client.config, const_cast<Pixmap *>(&copy), nullptr));
}

// Depths that no window of the screen has are depths of pixmaps all the same.
TEST_P(EglX11, PixmapsOfEveryDepth) {
  const Client client(*mServer);
  Display *x = mServer->connection();
  ASSERT_TRUE(client.makeCurrent(client.pbuffer(20, 10)));
  draw();
  rcFinish();
  const Picture picture = traced();
  const uint8_t *rgb = &picture.rgb[3 * (5 * 20 + 10)];
  for (const int depth : {16, 24, 32}) {
    const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 20, 10, unsigned(depth));
    XSync(x, False);
    const EGLSurface surface = eglCreatePixmapSurface(client.display, client.config, pixmap, nullptr);
    ASSERT_TRUE(surface) << depth;
    ASSERT_TRUE(client.makeCurrent(surface));
    draw();
    EXPECT_TRUE(eglWaitClient());
    XImage *image = XGetImage(x, pixmap, 10, 5, 1, 1, AllPlanes, ZPixmap);
    ASSERT_TRUE(image);
    const unsigned long pixel = XGetPixel(image, 0, 0);
    XDestroyImage(image);
    // The upper bits of each channel.
    const unsigned long wanted = depth == 16
                                     ? (rgb[0] >> 3ul) << 11 | (rgb[1] >> 2ul) << 5 | rgb[2] >> 3ul
                                     : (depth == 32 ? 0xff000000ul : 0) | rgb[0] << 16ul | rgb[1] << 8ul | rgb[2];
    EXPECT_EQ(pixel, wanted) << depth;
  }
}

TEST_P(EglX11, WindowsThatShowNoPicture) {
  const Client client(*mServer);
  Display *x = mServer->connection();
  XVisualInfo own{};
  own.visual = DefaultVisual(x, DefaultScreen(x));
  EXPECT_FALSE(client.surface(otherWindow(x, own, InputOnly)));
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
}

TEST_P(EglX11, APaletteIsNoMatch) {
  const XServer grey({"-screen", "0", "320x240x8"});
  ASSERT_TRUE(grey.connection());
  XSetErrorHandler(countErrors);
  const Client client(grey);
  EXPECT_FALSE(client.surface(client.window(20, 20)));
  EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
  EXPECT_FALSE(client.surface(None)) << "the library makes none of its own";
  EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  const EGLSurface off = client.pbuffer(8, 8);
  EXPECT_TRUE(client.makeCurrent(off));
  EXPECT_TRUE(client.swap(off)) << "pbuffers do not mind";
  // The config names a visual that holds colours, as the server has one beside its palettes.
  XVisualInfo wanted{};
  EGLint id = 0;
  EXPECT_TRUE(eglGetConfigAttrib(client.display, client.config, EGL_NATIVE_VISUAL_ID, &id));
  wanted.visualid = VisualID(id);
  int count = 0;
  XVisualInfo *info = XGetVisualInfo(grey.connection(), VisualIDMask, &wanted, &count);
  ASSERT_EQ(count, 1);
  EXPECT_EQ(info->c_class, TrueColor);
  EXPECT_TRUE(client.surface(otherWindow(grey.connection(), *info, InputOutput)));
  XFree(info);
}

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

TEST_P(EglX11, ASingleBufferShowsWithoutASwap) {
  const Client client(*mServer);
  const Window window = client.window(64, 64);
  const EGLAttrib single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
  const EGLSurface surface =
      eglCreatePlatformWindowSurface(client.display, client.config, const_cast<Window *>(&window), single);
  ASSERT_TRUE(client.makeCurrent(surface));
  draw();
  rcFinish();
  EXPECT_LE(difference(mServer->screenshot(window), traced()), GetParam().rounding);
}

TEST_P(EglX11, FiveHundredSizes) {
  const Client client(*mServer);
  const Window window = client.window(200, 100);
  const EGLSurface surface = client.surface(window);
  ASSERT_TRUE(client.makeCurrent(surface));
  std::mt19937 random(1);
  std::uniform_int_distribution<unsigned> side(1, 120);
  for (int i = 0; i < 500; ++i) {
    const unsigned width = side(random), height = side(random);
    mServer->resize(window, width, height);
    draw();
    ASSERT_TRUE(client.swap(surface));
    EGLint value = 0;
    EXPECT_TRUE(eglQuerySurface(client.display, surface, EGL_WIDTH, &value));
    ASSERT_EQ(value, EGLint(width));
    const bool look = i % 50 == 0;
    ASSERT_LE(look ? difference(mServer->screenshot(window), traced()) : 0, GetParam().rounding) << i;
  }
}

// A program asks before it draws: for its viewport, and for what of the last picture is left.
TEST_P(EglX11, ASizeIsKnownBeforeTheFrame) {
  const Client client(*mServer);
  const Window window = client.window(64, 48);
  const EGLSurface surface = client.surface(window);
  ASSERT_TRUE(client.makeCurrent(surface));
  ASSERT_TRUE(client.swap(surface));
  const auto value = [&](EGLint name) {
    EGLint answer = -1;
    EXPECT_TRUE(eglQuerySurface(client.display, surface, name, &answer));
    return answer;
  };
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 1);
  mServer->resize(window, 30, 20);
  EXPECT_EQ(value(EGL_WIDTH), 30);
  EXPECT_EQ(value(EGL_HEIGHT), 20);
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 0) << "the picture is gone";
  mServer->resize(window, 31, 20);
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 0) << "asked first";
  ASSERT_TRUE(client.swap(surface));
  EXPECT_EQ(traced().width, 31);
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 1);
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

const Screen kScreens[] = {
    {"Depth24", {"-screen", "0", "640x480x24"}, 0},
    {"Depth16", {"-screen", "0", "640x480x16"}, 8},
    {"Depth24WithoutSharedMemory", {"-screen", "0", "640x480x24", "-extension", "MIT-SHM"}, 0},
};

std::string nameOf(const testing::TestParamInfo<Screen> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Servers, EglX11, testing::ValuesIn(kScreens), nameOf);

}  // namespace
}  // namespace rc::test
