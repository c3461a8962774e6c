// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/window.h"

#include <poll.h>

#include <bit>

#include "input/error.h"

namespace rc::tool {
namespace {

constexpr long kEvents = KeyPressMask | KeyReleaseMask | ButtonPressMask | ButtonReleaseMask | PointerMotionMask |
                         StructureNotifyMask | ExposureMask | FocusChangeMask;
constexpr long kAddState = 1, kRemoveState = 0;  // [Extended Window Manager Hints, _NET_WM_STATE]

}  // namespace

XWindow::XWindow(int width, int height) : mDisplay(XOpenDisplay(nullptr)) {
  if (!mDisplay) reject("there is no X server to open a window on (DISPLAY); `raycore render` needs none");
  Display *display = mDisplay.get();
  const int screen = DefaultScreen(display);
  for (const int depth : {DefaultDepth(display, screen), 24, 30, 16}) {
    if (XMatchVisualInfo(display, screen, depth, TrueColor, &mVisual)) break;
  }
  if (!mVisual.visual) reject("the X server has no visual with direct colours");
  makeTables(*mVisual.visual);
  XSetWindowAttributes attributes{};
  attributes.event_mask = kEvents;
  attributes.colormap = XCreateColormap(display, RootWindow(display, screen), mVisual.visual, AllocNone);
  mWindow =
      XCreateWindow(display, RootWindow(display, screen), 0, 0, unsigned(width), unsigned(height), 0, mVisual.depth,
                    InputOutput, mVisual.visual, CWEventMask | CWColormap | CWBorderPixel, &attributes);
  mGraphics = XCreateGC(display, mWindow, 0, nullptr);
  Atom close = atom("WM_DELETE_WINDOW");
  XSetWMProtocols(display, mWindow, &close, 1);
  XkbSetDetectableAutoRepeat(display, True, nullptr);  // a key that is held is pressed once
  XMapWindow(display, mWindow);
}

XWindow::~XWindow() {
  XFreeGC(mDisplay.get(), mGraphics);
  XDestroyWindow(mDisplay.get(), mWindow);
}

void XWindow::makeTables(const Visual &visual) {
  const unsigned long masks[] = {visual.red_mask, visual.green_mask, visual.blue_mask};
  for (size_t channel = 0; channel < 3; ++channel) {
    const int shift = std::countr_zero(masks[channel]);
    const unsigned long most = masks[channel] >> shift;
    for (size_t value = 0; value < 256; ++value)
      mTables[channel][value] = uint32_t((value * most + 127) / 255 << shift);
  }
}

void XWindow::setTitle(const std::string &title) {
  if (title == mTitle) return;
  mTitle = title;
  XStoreName(mDisplay.get(), mWindow, title.c_str());
  XChangeProperty(mDisplay.get(), mWindow, atom("_NET_WM_NAME"), atom("UTF8_STRING"), 8, PropModeReplace,
                  reinterpret_cast<const unsigned char *>(title.data()), int(title.size()));
}

void XWindow::show(const Image &image) {
  XImage *frame = XCreateImage(mDisplay.get(), mVisual.visual, unsigned(mVisual.depth), ZPixmap, 0, nullptr,
                               unsigned(image.width), unsigned(image.height), 32, 0);
  if (!frame) return;
  frame->byte_order = std::endian::native == std::endian::little ? LSBFirst : MSBFirst;
  mPixels.resize(size_t(frame->bytes_per_line) * size_t(image.height));
  const bool narrow = frame->bits_per_pixel == 16;
  for (int y = 0; y < image.height; ++y) {
    const uint8_t *from = &image.rgba[size_t(y) * size_t(image.width) * 4];
    uint8_t *line = &mPixels[size_t(y) * size_t(frame->bytes_per_line)];
    for (int x = 0; x < image.width; ++x, from += 4) {
      const uint32_t pixel = mTables[0][from[0]] | mTables[1][from[1]] | mTables[2][from[2]];
      if (narrow) {
        reinterpret_cast<uint16_t *>(line)[x] = uint16_t(pixel);
      } else {
        reinterpret_cast<uint32_t *>(line)[x] = pixel;
      }
    }
  }
  frame->data = reinterpret_cast<char *>(mPixels.data());
  XPutImage(mDisplay.get(), mWindow, mGraphics, frame, 0, 0, 0, 0, unsigned(image.width), unsigned(image.height));
  frame->data = nullptr;  // it is ours
  XDestroyImage(frame);
  XFlush(mDisplay.get());
}

bool XWindow::hasManager() const {
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char *value = nullptr;
  XGetWindowProperty(mDisplay.get(), DefaultRootWindow(mDisplay.get()), atom("_NET_SUPPORTING_WM_CHECK"), 0, 1, False,
                     XA_WINDOW, &type, &format, &count, &left, &value);
  if (value) XFree(value);
  return count == 1;
}

void XWindow::askManager(bool on) {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = mWindow;
  event.xclient.message_type = atom("_NET_WM_STATE");
  event.xclient.format = 32;
  event.xclient.data.l[0] = on ? kAddState : kRemoveState;
  event.xclient.data.l[1] = long(atom("_NET_WM_STATE_FULLSCREEN"));
  XSendEvent(mDisplay.get(), DefaultRootWindow(mDisplay.get()), False,
             SubstructureNotifyMask | SubstructureRedirectMask, &event);
}

// Where nobody manages windows, the window takes the screen itself.
void XWindow::toggleFullScreen() {
  Display *display = mDisplay.get();
  mFullScreen = !mFullScreen;
  if (hasManager()) return askManager(mFullScreen);
  if (mFullScreen) {
    XWindowAttributes now{};
    XGetWindowAttributes(display, mWindow, &now);
    mBefore = {now.x, now.y, now.width, now.height};
    const int screen = DefaultScreen(display);
    XMoveResizeWindow(display, mWindow, 0, 0, unsigned(DisplayWidth(display, screen)),
                      unsigned(DisplayHeight(display, screen)));
    return;
  }
  XMoveResizeWindow(display, mWindow, mBefore[0], mBefore[1], unsigned(mBefore[2]), unsigned(mBefore[3]));
}

bool XWindow::isClose(const XEvent &event) const {
  return event.type == ClientMessage && event.xclient.message_type == atom("WM_PROTOCOLS") &&
         Atom(event.xclient.data.l[0]) == atom("WM_DELETE_WINDOW");
}

void XWindow::wait(int milliseconds) const {
  if (XPending(mDisplay.get()) > 0) return;
  pollfd descriptor{ConnectionNumber(mDisplay.get()), POLLIN, 0};
  poll(&descriptor, 1, milliseconds);
}

}  // namespace rc::tool
