// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// viewer.h: a window on a model: events change what is looked at, passes of tracing show it.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "draw/show.h"
#include "load/named_load.h"
#include "view/bindings.h"
#include "view/camera.h"
#include "view/canvas.h"
#include "view/drop.h"
#include "view/overlay.h"
#include "view/playback.h"
#include "view/refinement.h"
#include "view/switches.h"
#include "view/watch.h"
#include "view/window.h"

namespace rc::tool {

struct ViewSettings {
  std::string file;
  ShowSettings show;
  int samples = 16;
  std::string screenshots = "raycore-%04d.png";
  bool play = false, statistics = false;
  LoadOptions load;
};

class Viewer {
 public:
  explicit Viewer(const ViewSettings &settings);
  // Until it is closed; the exit code.
  int run();

 private:
  // viewer.cpp
  void open(const std::string &file, bool keepView);
  void tryToOpen(const std::string &file, bool keepView);
  void makeShow(Scene scene);
  View homeView();
  void step();
  void trace(const Pass &pass, bool moving);
  void present();
  void changed();  // another picture is wanted
  bool isMoving() const;
  Shot shotOf(const Pass &pass) const;

  // input.cpp
  void handle(const XEvent &event);
  void press(const XKeyEvent &event);
  void drag(int x, int y);
  void act(ViewAction action);
  void resize(int width, int height);
  void pick(int x, int y);
  void nextCamera();
  void takeScreenshot();
  void say(const std::string &message);

  ViewSettings mSettings;
  std::string mFile;
  XWindow mWindow;
  DropTarget mDrops;
  FileWatch mWatch;
  std::optional<Show> mShow;
  CameraController mCamera;
  Canvas mCanvas;
  Refinement mRefinement;
  Playback mPlayback;
  Switches mSwitches;
  MotionMeter mMotion;

  std::set<KeySym> mHeld;  // keys of flight
  std::optional<Drag> mDrag;
  int mDragX = 0, mDragY = 0, mDragged = 0;  // pixels since the button went down
  int mFileCamera = -1;
  double mNow = 0, mLastMotion = -1;  // seconds
  bool mDirty = true, mRedraw = true, mRunning = true, mHelp = false;
  std::string mMessage;
};

}  // namespace rc::tool
