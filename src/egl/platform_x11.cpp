// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// X11 windows and pixmaps.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "egl/error.h"
#include "egl/platform.h"
#include "egl/x11_connection.h"
#include "egl/x11_image.h"

namespace rc::egl {
namespace {

using namespace std::chrono_literals;

// A window made a moment ago on another connection may not have reached the server yet; a window manager takes its
// time.
constexpr auto kPatience = 1000ms, kPause = 5ms;

using Connection = std::shared_ptr<X11Connection>;

struct Geometry {
  Size size;
  int depth = 0;
};

std::optional<Geometry> geometryOf(const X11Connection &connection, ::Drawable drawable) {
  const ErrorTrap trap(connection);
  if (!connection.alive()) return std::nullopt;
  ::Window root;
  int x, y;
  unsigned width = 0, height = 0, border, depth = 0;
  if (!XGetGeometry(connection.display(), drawable, &root, &x, &y, &width, &height, &border, &depth)) {
    return std::nullopt;
  }
  return Geometry{{int(width), int(height)}, int(depth)};
}

// Where a window's pixels have their colours. [EGL 1.5, 3.5.1: EGL_BAD_MATCH]
ColourMasks masksOf(const XWindowAttributes &attributes) {
  require(X11Connection::holdsColours(*attributes.visual), EGL_BAD_MATCH);
  return colourMasks(*attributes.visual);
}

class X11Drawable : public NativeDrawable {
 public:
  X11Drawable(Connection connection, ::Drawable drawable, const ColourMasks &masks, int depth)
      : mConnection(std::move(connection)), mDrawable(drawable), mImage(*mConnection, masks, depth) {}

  std::optional<Size> size() override {
    const std::optional<Geometry> geometry = geometryOf(*mConnection, mDrawable);
    return geometry ? std::optional(geometry->size) : std::nullopt;
  }

  bool present(const hal::Target &picture) override { return mImage.put(mDrawable, picture); }

 protected:
  Connection mConnection;
  ::Drawable mDrawable;

 private:
  X11Image mImage;
};

// The library's own window.
class OwnWindow final : public X11Drawable {
 public:
  OwnWindow(const Connection &connection, ::Window window, const XWindowAttributes &attributes, Atom deleteWindow)
      : X11Drawable(connection, window, masksOf(attributes), attributes.depth), mDeleteWindow(deleteWindow) {}
  ~OwnWindow() override {
    const ErrorTrap trap(*mConnection);
    if (mConnection->alive()) XDestroyWindow(mConnection->display(), mDrawable);
  }

  bool closeRequested() override {
    const ErrorTrap trap(*mConnection);
    if (!mConnection->alive()) return false;
    XEvent event;
    bool close = false;
    while (XCheckTypedWindowEvent(mConnection->display(), mDrawable, KeyPress, &event)) {
      close |= XLookupKeysym(&event.xkey, 0) == XK_Escape;
    }
    while (XCheckTypedWindowEvent(mConnection->display(), mDrawable, ClientMessage, &event)) {
      close |= Atom(event.xclient.data.l[0]) == mDeleteWindow;
    }
    return close;
  }

 private:
  Atom mDeleteWindow;
};

class X11Platform final : public Platform {
 public:
  explicit X11Platform(Connection connection) : mConnection(std::move(connection)) {}

  NativeTraits traits() const override {
    NativeTraits traits;
    if (::Visual *visual = mConnection->windowVisual()) {
      traits.visualId = static_cast<EGLint>(XVisualIDFromVisual(visual));
      traits.visualType = visual->c_class;
    } else {
      traits.surfaceTypes &= ~EGL_WINDOW_BIT;
    }
    return traits;
  }

  std::unique_ptr<NativeDrawable> adoptWindow(EGLNativeWindowType window) override {
    XWindowAttributes attributes;
    if (!comesTrue([&] { return attributesOf(window, attributes); })) return nullptr;
    if (attributes.c_class != InputOutput) return nullptr;  // shows nothing
    return std::make_unique<X11Drawable>(mConnection, window, masksOf(attributes), attributes.depth);
  }

  std::unique_ptr<NativeDrawable> createWindow(Size size) override {
    // It would have the screen's default visual.
    const ::Visual *visual = DefaultVisual(mConnection->display(), mConnection->screen());
    if (!mConnection->alive() || !X11Connection::holdsColours(*visual)) return nullptr;
    Atom deleteWindow = None;
    const ::Window window = mapWindow(size, deleteWindow);
    awaitMapped(window);
    XWindowAttributes attributes;
    if (!attributesOf(window, attributes)) return nullptr;
    return std::make_unique<OwnWindow>(mConnection, window, attributes, deleteWindow);
  }

  std::optional<bool> holdsPictures(EGLNativePixmapType pixmap) override {
    const std::optional<Geometry> geometry = geometryOf(*mConnection, pixmap);
    if (!geometry || isWindow(pixmap)) return std::nullopt;
    return mConnection->masksOf(geometry->depth).has_value();
  }

  std::unique_ptr<NativeDrawable> adoptPixmap(EGLNativePixmapType pixmap) override {
    const std::optional<Geometry> geometry = geometryOf(*mConnection, pixmap);
    const std::optional<ColourMasks> masks = geometry ? mConnection->masksOf(geometry->depth) : std::nullopt;
    if (!masks) return nullptr;
    return std::make_unique<X11Drawable>(mConnection, pixmap, *masks, geometry->depth);
  }

 private:
  // Asks the server again and again, until it has lost our patience.
  template <class Condition>
  bool comesTrue(Condition &&condition) const {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
      if (!mConnection->alive() || std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(kPause);
    }
    return true;
  }
  ::Window mapWindow(Size size, Atom &deleteWindow) const {
    const ErrorTrap trap(*mConnection);
    if (!mConnection->alive()) return None;
    ::Display *display = mConnection->display();
    const ::Window window =
        XCreateSimpleWindow(display, mConnection->root(), 0, 0, unsigned(size.width), unsigned(size.height), 0, 0, 0);
    XStoreName(display, window, "RayCore");
    deleteWindow = XInternAtom(display, "WM_DELETE_WINDOW", False);
    XSetWMProtocols(display, window, &deleteWindow, 1);
    XSelectInput(display, window, KeyPressMask | StructureNotifyMask);
    XMapWindow(display, window);
    return window;
  }
  // What is put before it is mapped would be lost. A window manager may take its time, or never map it: the library's
  // other windows do not wait for that.
  void awaitMapped(::Window window) const {
    comesTrue([&] { return isMapped(window); });
    const ErrorTrap trap(*mConnection);
    if (mConnection->alive()) XSelectInput(mConnection->display(), window, KeyPressMask);
  }
  bool isMapped(::Window window) const {
    const ErrorTrap trap(*mConnection);
    XEvent event;
    return mConnection->alive() && XCheckTypedWindowEvent(mConnection->display(), window, MapNotify, &event);
  }
  bool attributesOf(::Window window, XWindowAttributes &attributes) const {
    const ErrorTrap trap(*mConnection);
    if (!mConnection->alive()) return false;
    return XGetWindowAttributes(mConnection->display(), window, &attributes) != 0;
  }
  bool isWindow(::Drawable drawable) const {
    XWindowAttributes ignored;
    return attributesOf(drawable, ignored);
  }

  Connection mConnection;
};

}  // namespace

std::shared_ptr<Platform> connectX11(void *native, int screen) {
  // Without a name there is no server: Xlib need not be asked.
  const char *name = std::getenv("DISPLAY");
  if (!native && (!name || !*name)) return nullptr;
  auto connection = X11Connection::open(native ? DisplayString(static_cast<::Display *>(native)) : nullptr, screen);
  return connection ? std::make_shared<X11Platform>(std::move(connection)) : nullptr;
}

}  // namespace rc::egl
