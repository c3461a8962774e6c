// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/viewer.h"

#include <chrono>
#include <filesystem>

#include "input/error.h"

namespace rc::tool {
namespace {

constexpr double kRest = 0.15;           // seconds without motion after which the picture is refined
constexpr int kIdle = 50, kBetween = 4;  // milliseconds

double clockSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ShowSettings settingsFor(const Scene &scene, ShowSettings settings) {
  settings.samples = 1;  // more of them are made pass by pass
  if (settings.animation.empty() && !scene.animations.empty()) settings.animation = std::string("0");
  return settings;
}

}  // namespace

Viewer::Viewer(const ViewSettings &settings)
    : mSettings(settings),
      mWindow(settings.show.width, settings.show.height),
      mDrops(mWindow),
      mRefinement(settings.samples),
      mSwitches(settings.show.bounces) {
  open(settings.file, false);
  if (settings.play) mPlayback.toggle();
}

int Viewer::run() {
  mNow = clockSeconds();
  while (mRunning) step();
  if (mSettings.load.verbose && !mMotion.summary().empty()) fmt::print(stderr, "{}\n", mMotion.summary());
  return 0;
}

// Throws InputError: it cannot be read. What was there stays.
void Viewer::open(const std::string &file, bool keepView) {
  mWindow.setTitle(std::filesystem::path(file).filename().string() + " - raycore - loading");
  XFlush(mWindow.display());
  const View before = mCamera.view();
  mWatch.watch(file);
  Scene scene = loadNamed(file);
  if (file != mFile) mSettings.show.camera = mFile.empty() ? mSettings.show.camera : "";
  mFile = file;
  makeShow(std::move(scene));
  printNotes(file, mShow->scene(), mSettings.load);
  mCamera.place(keepView ? before : homeView(), mShow->bounds(), mShow->zUp());
  mFileCamera = -1;
  changed();
}

void Viewer::makeShow(Scene scene) {
  mShow.reset();  // there is one EGL display
  const ShowSettings settings = settingsFor(scene, mSettings.show);
  mShow.emplace(std::move(scene), settings);
  const int animation = mShow->animation();
  mPlayback = Playback(animation < 0 ? 0 : mShow->scene().animations[size_t(animation)].duration());
  mSwitches.apply(*mShow);
  mShow->fixLights(homeView());
  mCanvas.resize(settings.width, settings.height);
  mRefinement.resize(settings.width, settings.height);
}

void Viewer::tryToOpen(const std::string &file, bool keepView) {
  try {
    open(file, keepView);
    say(keepView ? "loaded again" : file);
  } catch (const InputError &error) {
    if (!mShow) throw;
    say(error.what());
    if (file != mFile) mWatch.watch(mFile);
  }
}

View Viewer::homeView() { return mShow->viewAt(mPlayback.seconds()); }

void Viewer::changed() {
  mDirty = true;
  mRefinement.restart();
}

bool Viewer::isMoving() const { return mPlayback.playing() || !mHeld.empty() || mNow - mLastMotion < kRest; }

void Viewer::step() {
  const double before = mNow;
  mNow = clockSeconds();
  const auto passed = static_cast<float>(std::min(mNow - before, 0.1));
  while (mRunning && XPending(mWindow.display()) > 0) {
    XEvent event;
    XNextEvent(mWindow.display(), &event);
    handle(event);
  }
  Vec3 way(0);
  for (const KeySym key : mHeld) way += flightOf(key).value_or(Vec3(0));
  if (way != Vec3(0)) mCamera.fly(way, passed);
  mPlayback.advance(passed);
  if (way != Vec3(0) || mPlayback.playing()) changed();
  if (mWatch.changed()) tryToOpen(mFile, true);

  const bool moving = isMoving();
  if (moving && !mDirty) return mWindow.wait(kBetween);
  const std::optional<Pass> pass = mRefinement.next(moving);
  if (pass) return trace(*pass, moving);
  if (mRedraw) present();
  mWindow.wait(kIdle);
}

Shot Viewer::shotOf(const Pass &pass) const {
  return {mCamera.view(), mPlayback.seconds(), mRefinement.widthOf(pass.step), mRefinement.heightOf(pass.step),
          pass.row,       pass.rows,           samplePlace(pass.sample)};
}

void Viewer::trace(const Pass &pass, bool moving) {
  const double start = clockSeconds();
  const Image image = mShow->picture(shotOf(pass));
  mRefinement.done(pass, clockSeconds() - start);
  if (pass.step > 1) {
    mCanvas.showCoarse(image);
  } else {
    mCanvas.addRows(image, pass.row, pass.sample);
  }
  mDirty = false;
  present();
  if (moving) mMotion.frame(clockSeconds() - start);
}

void Viewer::present() {
  std::vector<std::string> panel;
  if (mHelp) panel = bindingLines();
  if (mSettings.statistics) {
    panel = statisticsLines(*mShow, mRefinement, mPlayback, mMotion);
    panel.push_back(mSwitches.text());
  }
  const std::string name = std::filesystem::path(mFile).filename().string();
  mWindow.setTitle(fmt::format("{} - raycore - {}/{}", name, mRefinement.samplesDone(), mRefinement.samples()));
  mRedraw = false;
  if (panel.empty() && mMessage.empty()) return mWindow.show(mCanvas.image());
  Image image = mCanvas.image();
  drawOverlay(image, panel, mMessage);
  mWindow.show(image);
}

}  // namespace rc::tool
