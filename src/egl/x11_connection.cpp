// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/x11_connection.h"

#include <X11/Xutil.h>

#include <mutex>

#include "base/log.h"

namespace rc::egl {
namespace {

// The state of the one trap that lives: Xlib has a single handler of lost servers for the process.
std::mutex sTrapMutex;
::Display *sTrapped = nullptr;
XIOErrorHandler sOuter = nullptr;

// Xlib's own handler would end the process before it comes to X11Connection::serverGone.
int noteLostServer(::Display *display) { return display != sTrapped && sOuter ? sOuter(display) : 0; }

// A program that sets its own handler meanwhile is given ours as the one before: it may come back at any time.
void catchLostServer() {
  const XIOErrorHandler before = XSetIOErrorHandler(noteLostServer);
  if (before != noteLostServer) sOuter = before;
}
void releaseLostServer() {
  const XIOErrorHandler mine = XSetIOErrorHandler(sOuter);
  if (mine != noteLostServer) XSetIOErrorHandler(mine);  // the program has set it since
}

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

X11Connection::X11Connection(::Display *display, int screen) : mDisplay(display), mScreen(screen), mErrors(display) {
  XSetIOErrorExitHandler(display, serverGone, this);
}

X11Connection::~X11Connection() {
  const ErrorTrap trap(*this);
  static_cast<void>(trap.failed());  // a server that has gone is found out here
  if (!alive()) return;
  XCloseDisplay(mDisplay);
  mAlive = false;
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
  catchLostServer();
  connection.errors().forget();
}

ErrorTrap::~ErrorTrap() {
  sync();
  releaseLostServer();
  sTrapped = nullptr;
  sTrapMutex.unlock();
}

bool ErrorTrap::failed() const {
  sync();
  return mConnection.errors().noted() || !mConnection.alive();
}

void ErrorTrap::sync() const {
  if (mConnection.alive()) XSync(mConnection.display(), False);
}

}  // namespace rc::egl
