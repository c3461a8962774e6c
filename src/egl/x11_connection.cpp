// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/x11_connection.h"

#include <X11/Xutil.h>

#include <mutex>

#include "base/log.h"

namespace rc::egl {
namespace {

// The state of the one trap that lives: Xlib has a single error handler for the process.
std::mutex sTrapMutex;
::Display *sTrapped = nullptr;
bool sFailed = false;
XErrorHandler sOuter = nullptr;
XIOErrorHandler sOuterIo = nullptr;

int noteError(::Display *display, XErrorEvent *event) {
  if (display != sTrapped) return sOuter ? sOuter(display, event) : 0;
  sFailed = true;
  return 0;
}

// Xlib's own handler would end the process before it comes to X11Connection::serverGone.
int noteLostServer(::Display *display) { return display != sTrapped && sOuterIo ? sOuterIo(display) : 0; }

}  // namespace

std::shared_ptr<X11Connection> X11Connection::open(const char *name, int screen) {
  static std::once_flag threads;
  std::call_once(threads, [] { XInitThreads(); });
  ::Display *display = XOpenDisplay(name);
  if (!display) return nullptr;
  const int chosen = screen < 0 ? DefaultScreen(display) : screen;
  if (chosen < ScreenCount(display)) return std::shared_ptr<X11Connection>(new X11Connection(display, chosen));
  XCloseDisplay(display);
  return nullptr;
}

X11Connection::X11Connection(::Display *display, int screen) : mDisplay(display), mScreen(screen) {
  XSetIOErrorExitHandler(display, serverGone, this);
}

X11Connection::~X11Connection() {
  if (mAlive) XCloseDisplay(mDisplay);
}

// Called instead of exit, where the connection is found broken.
void X11Connection::serverGone(::Display *, void *connection) {
  if (!static_cast<X11Connection *>(connection)->mAlive.exchange(false)) return;
  log(LogLevel::Warning, "the X server has gone away: windows on it are lost, swaps fail with EGL_BAD_NATIVE_WINDOW");
}

::Visual *X11Connection::windowVisual() const {
  ::Visual *usual = DefaultVisual(mDisplay, mScreen);
  if (holdsColours(*usual)) return usual;
  XVisualInfo wanted{};
  wanted.screen = mScreen;
  wanted.c_class = TrueColor;
  int count = 0;
  const std::unique_ptr<XVisualInfo, int (*)(void *)> found(
      XGetVisualInfo(mDisplay, VisualScreenMask | VisualClassMask, &wanted, &count), XFree);
  return count > 0 ? found->visual : nullptr;
}

// As the screen's windows of that depth have them. A pixmap may be of a depth that no window has: then the usual way.
std::optional<ColourMasks> X11Connection::masksOf(int depth) const {
  XVisualInfo info;
  if (XMatchVisualInfo(mDisplay, mScreen, depth, TrueColor, &info)) return colourMasks(*info.visual);
  switch (depth) {
    case 15:
      return ColourMasks{0x7c00, 0x03e0, 0x001f};
    case 16:
      return ColourMasks{0xf800, 0x07e0, 0x001f};
    case 24:
    case 32:
      return ColourMasks{0xff0000, 0x00ff00, 0x0000ff};
    case 30:
      return ColourMasks{0x3ff00000, 0x000ffc00, 0x000003ff};
    default:
      return std::nullopt;
  }
}

ErrorTrap::ErrorTrap(const X11Connection &connection) : mConnection(connection) {
  sTrapMutex.lock();
  sTrapped = connection.display();
  sOuterIo = XSetIOErrorHandler(noteLostServer);
  sOuter = XSetErrorHandler(noteError);
  sFailed = false;
}

ErrorTrap::~ErrorTrap() {
  sync();
  XSetErrorHandler(sOuter);
  XSetIOErrorHandler(sOuterIo);
  sTrapped = nullptr;
  sTrapMutex.unlock();
}

bool ErrorTrap::failed() const {
  sync();
  return sFailed || !mConnection.alive();
}

void ErrorTrap::sync() const {
  if (mConnection.alive()) XSync(mConnection.display(), False);
}

}  // namespace rc::egl
