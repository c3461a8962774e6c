// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "window/x11_fixture.h"

#include <X11/Xutil.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace rc::test {
namespace {

std::vector<char *> pointersTo(const std::vector<std::string> &strings) {
  std::vector<char *> pointers;
  for (const std::string &string : strings) pointers.push_back(const_cast<char *>(string.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

int ignoreErrors(Display *, XErrorEvent *) { return 0; }

}  // namespace

bool eventually(const std::function<bool()> &condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

Process::Process(const std::vector<std::string> &command, const std::vector<std::string> &environment) {
  const std::vector<char *> arguments = pointersTo(command);
  mId = fork();
  if (mId != 0) return;
  for (const std::string &entry : environment) putenv(const_cast<char *>(entry.c_str()));
  execvp(arguments[0], arguments.data());
  _exit(127);
}

Process::~Process() {
  if (!running()) return;
  kill(mId, SIGKILL);
  waitpid(mId, nullptr, 0);
}

bool Process::running() {
  int status = 0;
  if (mStatus || mId <= 0) return false;
  if (waitpid(mId, &status, WNOHANG) != mId) return true;
  mStatus = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return false;
}

std::optional<int> Process::exitCode() {
  eventually([&] { return !running(); });
  return mStatus;
}

bool XServer::available() { return std::system("command -v Xvfb >/dev/null 2>&1") == 0; }

XServer::XServer(const std::vector<std::string> &options) {
  int ends[2];
  if (pipe(ends) != 0) return;
  std::vector<std::string> command{"Xvfb", "-displayfd", std::to_string(ends[1]), "-nolisten", "tcp"};
  command.insert(command.end(), options.begin(), options.end());
  mServer.emplace(command, std::vector<std::string>{});
  close(ends[1]);
  std::string number;  // the server writes it when it is ready
  for (char digit; read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
  close(ends[0]);
  if (number.empty()) return;
  mName = ":" + number;
  mConnection = XOpenDisplay(mName.c_str());
  XSetErrorHandler(ignoreErrors);  // windows come and go while they are looked at
}

XServer::~XServer() {
  if (mConnection) XCloseDisplay(mConnection);
}

std::string XServer::titleOf(Window window) const {
  char *name = nullptr;
  if (!XFetchName(mConnection, window, &name) || !name) return {};
  std::string title = name;
  XFree(name);
  return title;
}

Window XServer::find(const std::string &title) const {
  Window root, parent, *children = nullptr, found = 0;
  unsigned count = 0;
  if (!XQueryTree(mConnection, DefaultRootWindow(mConnection), &root, &parent, &children, &count)) return 0;
  for (unsigned i = 0; i < count && !found; ++i) {
    if (titleOf(children[i]).rfind(title, 0) == 0) found = children[i];
  }
  if (children) XFree(children);
  return found;
}

Picture XServer::screenshot(Window window) const {
  Picture picture;
  XWindowAttributes attributes;
  if (!XGetWindowAttributes(mConnection, window, &attributes)) return picture;
  XImage *image =
      XGetImage(mConnection, window, 0, 0, unsigned(attributes.width), unsigned(attributes.height), AllPlanes, ZPixmap);
  if (!image) return picture;
  picture = {image->width, image->height, {}};
  const unsigned long masks[] = {attributes.visual->red_mask, attributes.visual->green_mask,
                                 attributes.visual->blue_mask};
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      for (unsigned long mask : masks) picture.rgb.push_back(uint8_t((pixel & mask) * 255 / mask));
    }
  }
  XDestroyImage(image);
  return picture;
}

void XServer::resize(Window window, unsigned width, unsigned height) const {
  XResizeWindow(mConnection, window, width, height);
  XSync(mConnection, False);
}

void XServer::send(Window window, long mask, XEvent &event) const {
  event.xany.display = mConnection;
  event.xany.window = window;
  XSendEvent(mConnection, window, True, mask, &event);
  XSync(mConnection, False);
}

void XServer::pressKey(Window window, KeySym key, unsigned state) const {
  XEvent event = {};
  event.xkey.type = KeyPress;
  event.xkey.root = DefaultRootWindow(mConnection);
  event.xkey.keycode = XKeysymToKeycode(mConnection, key);
  event.xkey.state = state;
  event.xkey.same_screen = True;
  send(window, KeyPressMask, event);
}

void XServer::pressButton(Window window, unsigned button, int x, int y, unsigned state) const {
  XEvent event = {};
  event.xbutton.type = ButtonPress;
  event.xbutton.button = button;
  event.xbutton.x = x;
  event.xbutton.y = y;
  event.xbutton.state = state;
  send(window, ButtonPressMask, event);
}

void XServer::releaseButton(Window window, unsigned button, int x, int y, unsigned state) const {
  XEvent event = {};
  event.xbutton.type = ButtonRelease;
  event.xbutton.button = button;
  event.xbutton.x = x;
  event.xbutton.y = y;
  event.xbutton.state = state;
  send(window, ButtonReleaseMask, event);
}

void XServer::moveMouse(Window window, int x, int y) const {
  XEvent event = {};
  event.xmotion.type = MotionNotify;
  event.xmotion.x = x;
  event.xmotion.y = y;
  send(window, PointerMotionMask, event);
}

void XServer::pressCloseButton(Window window) const {
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(mConnection, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(mConnection, "WM_DELETE_WINDOW", False));
  XSendEvent(mConnection, window, False, NoEventMask, &event);
  XSync(mConnection, False);
}

}  // namespace rc::test
