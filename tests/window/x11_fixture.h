// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11_fixture.h: a virtual X server, a program in it, and what a user does to its window.
#pragma once

#include <X11/Xlib.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "images/picture.h"

namespace rc::test {

// Waits for up to ten seconds for something to become true.
bool eventually(const std::function<bool()> &condition);

// A process of ours; killed if it still runs at the end.
class Process {
 public:
  // environment: "NAME=value" entries on top of ours; the program's output goes where ours goes.
  Process(const std::vector<std::string> &command, const std::vector<std::string> &environment);
  ~Process();
  Process(const Process &) = delete;
  Process &operator=(const Process &) = delete;

  bool running();
  // The exit code once it has ended by itself; nothing if it does not.
  std::optional<int> exitCode();

 private:
  int mId = -1;
  std::optional<int> mStatus;
};

// Xvfb on a display of its own.
class XServer {
 public:
  static bool available();
  explicit XServer(const std::vector<std::string> &options);
  ~XServer();
  XServer(const XServer &) = delete;
  XServer &operator=(const XServer &) = delete;

  // ":n"; empty if the server did not start.
  const std::string &name() const { return mName; }
  Display *connection() const { return mConnection; }

  // The window whose title begins so; 0 if there is none.
  Window find(const std::string &title) const;
  std::string titleOf(Window window) const;
  // What the window shows.
  Picture screenshot(Window window) const;
  void resize(Window window, unsigned width, unsigned height) const;
  // state: modifiers and buttons that are down already, as X has them.
  void pressKey(Window window, KeySym key, unsigned state = 0) const;
  void pressButton(Window window, unsigned button, int x, int y, unsigned state) const;
  void releaseButton(Window window, unsigned button, int x, int y, unsigned state) const;
  void moveMouse(Window window, int x, int y) const;
  // What a window manager does when its close button is pressed.
  void pressCloseButton(Window window) const;

 private:
  void send(Window window, long mask, XEvent &event) const;

  std::optional<Process> mServer;
  std::string mName;
  Display *mConnection = nullptr;
};

}  // namespace rc::test
