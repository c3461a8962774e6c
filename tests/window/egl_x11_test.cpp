// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// EGL on X servers of several depths: windows and pixmaps show what a pbuffer holds, and follow sizes.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <random>

#include "RC/rcu.h"
#include "window/egl_x11_fixture.h"

// After what Xlib's macros would be in the way of.
#include <X11/Xutil.h>

namespace rc::test {
namespace {

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
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 0) << "the picture will be lost";
  EXPECT_EQ(traced().width, 64) << "asking leaves it alone: it may be on its way";
  mServer->resize(window, 31, 20);
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 0) << "asked first";
  ASSERT_TRUE(client.swap(surface));
  EXPECT_EQ(traced().width, 31);
  EXPECT_EQ(value(EGL_BUFFER_AGE_EXT), 1);
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
