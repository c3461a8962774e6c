// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// window.h: a window of the X Window System that shows a picture.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "view/x11.h"

namespace rc::tool {

class XWindow {
 public:
  // Throws InputError: there is no display, or none with colours.
  XWindow(int width, int height);
  ~XWindow();
  XWindow(const XWindow &) = delete;
  XWindow &operator=(const XWindow &) = delete;

  Display *display() const { return mDisplay.get(); }
  Window id() const { return mWindow; }
  Atom atom(const char *name) const { return XInternAtom(mDisplay.get(), name, False); }

  void setTitle(const std::string &title);
  void show(const Image &image);
  void toggleFullScreen();
  // The button that closes it was pressed.
  bool isClose(const XEvent &event) const;
  // Waits for an event, but not longer.
  void wait(int milliseconds) const;

 private:
  struct Close {
    void operator()(Display *display) const { XCloseDisplay(display); }
  };
  void makeTables(const Visual &visual);
  bool hasManager() const;
  void askManager(bool on);

  std::unique_ptr<Display, Close> mDisplay;
  Window mWindow = 0;
  GC mGraphics = nullptr;
  XVisualInfo mVisual{};
  std::array<std::array<uint32_t, 256>, 3> mTables{};  // a channel's value -> its bits of a pixel
  std::vector<uint8_t> mPixels;
  std::string mTitle;
  bool mFullScreen = false;
  std::array<int, 4> mBefore{};  // place and size before full screen
};

}  // namespace rc::tool
