// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What a person does with the window, and what follows from it.

#include <cstdlib>
#include <filesystem>

#include "input/error.h"
#include "output/picture_file.h"
#include "output/sequence.h"
#include "view/viewer.h"

namespace rc::tool {
namespace {

constexpr float kTurn = 3.0f;        // radians for a drag over the height of the window
constexpr int kStill = 3;            // pixels: less is a click
constexpr float kScrub = 1.0f / 30;  // seconds
constexpr int kMostScreenshots = 9999;

}  // namespace

void Viewer::handle(const XEvent &event) {
  if (mWindow.isClose(event)) mRunning = false;
  if (const auto file = mDrops.handle(event)) return tryToOpen(*file, false);
  switch (event.type) {
    case KeyPress:
      return press(event.xkey);
    case KeyRelease:
      mHeld.erase(XkbKeycodeToKeysym(mWindow.display(), KeyCode(event.xkey.keycode), 0, 0));
      return;
    case FocusOut:
      return mHeld.clear();
    case ButtonPress:
      if (event.xbutton.button == Button4 || event.xbutton.button == Button5) {
        mCamera.zoom(event.xbutton.button == Button4 ? 1 : -1);
        mLastMotion = mNow;
        return changed();
      }
      mDrag = dragOf(event.xbutton.button, event.xbutton.state);
      mDragX = event.xbutton.x, mDragY = event.xbutton.y, mDragged = 0;
      return;
    case MotionNotify:
      return drag(event.xmotion.x, event.xmotion.y);
    case ButtonRelease:
      if (mDrag == Drag::Orbit && mDragged <= kStill) pick(event.xbutton.x, event.xbutton.y);
      mDrag.reset();
      return;
    case ConfigureNotify:
      return resize(event.xconfigure.width, event.xconfigure.height);
    case Expose:
      mRedraw = true;
      return;
    default:
      return;
  }
}

// Letters count without Shift; where a key has a character only with it, such as "+", that counts.
void Viewer::press(const XKeyEvent &event) {
  const auto code = KeyCode(event.keycode);
  const KeySym plain = XkbKeycodeToKeysym(mWindow.display(), code, 0, 0);
  const KeySym shifted = XkbKeycodeToKeysym(mWindow.display(), code, 0, event.state & ShiftMask ? 1 : 0);
  if (flightOf(plain)) {
    mHeld.insert(plain);
    return;
  }
  const auto action = actionOf(shifted);
  if (const auto found = action ? action : actionOf(plain)) act(*found);
}

void Viewer::drag(int x, int y) {
  if (!mDrag) return;
  const int across = x - mDragX, down = y - mDragY;
  mDragged += std::abs(across) + std::abs(down);
  mDragX = x, mDragY = y;
  if (mDragged <= kStill) return;
  const Vec2 way = Vec2(across, down) / float(mShow->settings().height);
  if (mDrag == Drag::Orbit) mCamera.orbit(-kTurn * way.x, kTurn * way.y);
  if (mDrag == Drag::Look) mCamera.look(-way.x, way.y);
  if (mDrag == Drag::Pan) mCamera.pan(-way.x, way.y);
  mLastMotion = mNow;
  changed();
}

void Viewer::act(ViewAction action) {
  const auto place = [&](const View &view) {
    mCamera.place(view, mShow->bounds(), mShow->zUp());
    changed();
  };
  const auto change = [&](auto &&how) {
    how();
    mSwitches.apply(*mShow);
    say(mSwitches.text());
    changed();
  };
  const auto scrub = [&](float seconds) {
    mPlayback.scrub(seconds);
    say(fmt::format("{:.3f} s", mPlayback.seconds()));
    changed();
  };
  switch (action) {
    case ViewAction::FrameAll: {
      const ShowSettings &s = mShow->settings();
      return place(framing(mShow->bounds(), float(s.width) / float(s.height), s.fov, mShow->zUp(), s.angle));
    }
    case ViewAction::Reset:
      mFileCamera = -1;
      return place(homeView());
    case ViewAction::NextCamera:
      return nextCamera();
    case ViewAction::PlayPause:
      mPlayback.toggle();
      return changed();
    case ViewAction::ScrubBack:
      return scrub(-kScrub);
    case ViewAction::ScrubOn:
      return scrub(kScrub);
    case ViewAction::FewerBounces:
      return change([&] { mSwitches.changeBounces(-1); });
    case ViewAction::MoreBounces:
      return change([&] { mSwitches.changeBounces(1); });
    case ViewAction::Shadows:
      return change([&] { mSwitches.toggleShadows(); });
    case ViewAction::Filter:
      return change([&] { mSwitches.nextFilter(); });
    case ViewAction::Structure:
      return change([&] { mSwitches.nextStructure(); });
    case ViewAction::Statistics:
      mSettings.statistics = !mSettings.statistics;
      mHelp = false;
      break;
    case ViewAction::Help:
      mHelp = !mHelp;
      mSettings.statistics = false;
      break;
    case ViewAction::Screenshot:
      return takeScreenshot();
    case ViewAction::FullScreen:
      return mWindow.toggleFullScreen();
    case ViewAction::Quit:
      mRunning = false;
      return;
  }
  mRedraw = true;
}

void Viewer::resize(int width, int height) {
  const ShowSettings &now = mShow->settings();
  if (width == now.width && height == now.height) return;
  mShow->resize(width, height);
  mSettings.show.width = width;
  mSettings.show.height = height;
  mCanvas.resize(width, height);
  mRefinement.resize(width, height);
  changed();
}

void Viewer::pick(int x, int y) {
  const ShowSettings &s = mShow->settings();
  if (x < 0 || y < 0 || x >= s.width || y >= s.height) return;
  const auto found = mShow->pick(shotOf({1, 0, 0, s.height}), x, s.height - 1 - y);
  if (!found) return say("nothing is there");
  const std::string line = fmt::format("{}: distance {:.4g}, at ({:.4g}, {:.4g}, {:.4g})", found->material,
                                       found->distance, found->place.x, found->place.y, found->place.z);
  if (!mSettings.load.quiet) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }
  say(line);
}

// Those of the file, one after the other, and then the one that frames the model.
void Viewer::nextCamera() {
  const int count = static_cast<int>(mShow->scene().cameras.size());
  if (count == 0) return say("the file has no cameras");
  mFileCamera = mFileCamera + 1 < count ? mFileCamera + 1 : -1;
  if (mFileCamera < 0) return act(ViewAction::FrameAll);
  const Pose pose = poseAt(mShow->scene(), mShow->animation(), mPlayback.seconds());
  try {
    mCamera.place(fromFile(mShow->scene(), pose, std::to_string(mFileCamera)), mShow->bounds(), mShow->zUp());
  } catch (const InputError &error) {
    return say(error.what());
  }
  say(fmt::format("camera {}: {}", mFileCamera, mShow->scene().cameras[size_t(mFileCamera)].name));
  changed();
}

// Under the first number that is free.
void Viewer::takeScreenshot() {
  try {
    for (int number = 1; number <= kMostScreenshots; ++number) {
      const std::string file = fileOfFrame(mSettings.screenshots, number);
      if (std::filesystem::exists(file)) continue;
      writePicture(mCanvas.image(), file);
      return say(fmt::format("{} is written", file));
    }
    say("there are too many screenshots");
  } catch (const InputError &error) {
    say(error.what());
  }
}

void Viewer::say(const std::string &message) {
  mMessage = message;
  mRedraw = true;
}

}  // namespace rc::tool
