// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// X11 windows, on a connection of our own: the program's may be in use by another thread.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "egl/platform.h"
#include "egl/x11_image.h"

namespace rc::egl {
namespace {

using namespace std::chrono_literals;

// A window made a moment ago on another connection may not have reached the server yet.
constexpr auto kPatience = 1000ms, kPause = 5ms;

struct CloseDisplay {
  void operator()(::Display *display) const { XCloseDisplay(display); }
};
using Connection = std::shared_ptr<::Display>;

class X11Window final : public NativeWindow {
 public:
  X11Window(Connection connection, ::Window window, const XWindowAttributes &attributes, bool ours)
      : mConnection(std::move(connection)), mWindow(window), mOurs(ours), mImage(mConnection.get(), attributes) {
    if (ours) mDeleteWindow = XInternAtom(mConnection.get(), "WM_DELETE_WINDOW", False);
  }
  ~X11Window() override {
    if (!mOurs) return;
    const ErrorTrap trap(mConnection.get());
    XDestroyWindow(mConnection.get(), mWindow);
  }

  std::optional<Size> size() override {
    const ErrorTrap trap(mConnection.get());
    ::Window root;
    int x, y;
    unsigned width, height, border, depth;
    if (!XGetGeometry(mConnection.get(), mWindow, &root, &x, &y, &width, &height, &border, &depth)) return std::nullopt;
    return Size{int(width), int(height)};
  }

  bool present(const hal::Target &picture) override { return mImage.put(mWindow, picture); }

  bool closeRequested() override {
    if (!mOurs) return false;
    XEvent event;
    bool close = false;
    while (XCheckTypedWindowEvent(mConnection.get(), mWindow, KeyPress, &event)) {
      close |= XLookupKeysym(&event.xkey, 0) == XK_Escape;
    }
    while (XCheckTypedWindowEvent(mConnection.get(), mWindow, ClientMessage, &event)) {
      close |= Atom(event.xclient.data.l[0]) == mDeleteWindow;
    }
    return close;
  }

 private:
  Connection mConnection;
  ::Window mWindow;
  bool mOurs;
  Atom mDeleteWindow = None;
  X11Image mImage;
};

class X11Platform final : public Platform {
 public:
  explicit X11Platform(::Display *display) : mConnection(display, CloseDisplay()) {}

  std::unique_ptr<NativeWindow> adopt(EGLNativeWindowType window) override {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    XWindowAttributes attributes;
    while (!attributesOf(window, attributes)) {
      if (std::chrono::steady_clock::now() > deadline) return nullptr;
      std::this_thread::sleep_for(kPause);
    }
    return std::make_unique<X11Window>(mConnection, window, attributes, false);
  }

  std::unique_ptr<NativeWindow> create(Size size) override {
    ::Display *display = mConnection.get();
    const ::Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, unsigned(size.width),
                                                unsigned(size.height), 0, 0, 0);
    XStoreName(display, window, "RayCore");
    Atom deleteWindow = XInternAtom(display, "WM_DELETE_WINDOW", False);
    XSetWMProtocols(display, window, &deleteWindow, 1);
    XSelectInput(display, window, KeyPressMask | StructureNotifyMask);
    XMapWindow(display, window);
    XEvent event;
    do {  // what is put before it is mapped would be lost
      XWindowEvent(display, window, StructureNotifyMask, &event);
    } while (event.type != MapNotify);
    XSelectInput(display, window, KeyPressMask);
    XWindowAttributes attributes;
    if (!attributesOf(window, attributes)) return nullptr;
    return std::make_unique<X11Window>(mConnection, window, attributes, true);
  }

 private:
  bool attributesOf(::Window window, XWindowAttributes &attributes) {
    const ErrorTrap trap(mConnection.get());
    return XGetWindowAttributes(mConnection.get(), window, &attributes) != 0;
  }

  Connection mConnection;
};

}  // namespace

std::unique_ptr<Platform> connectX11(EGLNativeDisplayType native) {
  static std::once_flag threads;
  std::call_once(threads, [] { XInitThreads(); });
  ::Display *display = XOpenDisplay(native ? DisplayString(reinterpret_cast<::Display *>(native)) : nullptr);
  return display ? std::make_unique<X11Platform>(display) : nullptr;
}

}  // namespace rc::egl
