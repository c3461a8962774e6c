// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/show.h"

#include <RC/rc.h>

#include <charconv>
#include <chrono>
#include <cstdlib>

#include "input/error.h"

namespace rc::tool {
namespace {

// RayCore reads it once, before the first picture.
int withSamples(int samples, int width) {
  setenv("RAYCORE_SAMPLES", std::to_string(samples).c_str(), 1);
  return width;
}

bool zIsUp(const Scene &scene, const std::string &up) { return up.empty() ? scene.zUp : up == "z"; }

Bounds boundsOverTime(const Scene &scene, int animation) {
  constexpr int kMoments = 8;
  if (animation < 0) return boundsOf(scene, poseAt(scene, -1, 0));
  Bounds all;
  const float end = scene.animations[size_t(animation)].duration();
  for (int i = 0; i <= kMoments; ++i) {
    const Bounds bounds = boundsOf(scene, poseAt(scene, animation, end * float(i) / kMoments));
    if (bounds.empty()) continue;
    all.add(bounds.low);
    all.add(bounds.high);
  }
  return all;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int integerOf(RCenum name) {
  RCint value = 0;
  rcGetIntegerv(name, &value);
  return value;
}

}  // namespace

int animationNamed(const Scene &scene, const std::string &name) {
  if (name.empty() || name == "none") return -1;
  for (size_t i = 0; i < scene.animations.size(); ++i) {
    if (scene.animations[i].name == name) return static_cast<int>(i);
  }
  size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool isNumber = error == std::errc() && end == name.data() + name.size();
  if (isNumber && index < scene.animations.size()) return static_cast<int>(index);
  reject("--animation: no animation \"{}\", the file has {}", name, scene.animations.size());
}

Show::Show(Scene scene, ShowSettings settings)
    : mScene(std::move(scene)),
      mSettings(std::move(settings)),
      mZUp(zIsUp(mScene, mSettings.up)),
      mBackground(backgroundFrom(mSettings.background)),
      mAnimation(animationNamed(mScene, mSettings.animation)),
      mMoving(movingNodes(mScene, mAnimation)),
      mBounds(boundsOverTime(mScene, mAnimation)),
      mTarget(withSamples(mSettings.samples, mSettings.width), mSettings.height),
      mModel(mScene),
      mStage(mBackground, mSettings.ground, mZUp) {
  rcDepthBounce(RCuint(mSettings.bounces));
  checkErrors("making materials");
  if (mBounds.empty()) mScene.note("there is no surface to draw");
}

View Show::viewOf(const Pose &pose) const {
  const float aspect = float(mSettings.width) / float(mSettings.height);
  View view = mSettings.camera.empty() ? framing(mBounds, aspect, mSettings.fov, mZUp, mSettings.angle)
                                       : fromFile(mScene, pose, mSettings.camera);
  if (mSettings.lookAt) view.centre = *mSettings.lookAt;
  if (mSettings.eye) view.eye = *mSettings.eye;
  if (view.eye == view.centre) reject("--eye and --look-at are the same point");
  return view;
}

void Show::drawStanding(const Pose &pose) {
  rcSceneAllInit();
  rcStaticSceneBegin();
  mModel.draw(pose, mMoving, Model::Part::Standing);
  mStage.draw(mBounds);
  rcStaticSceneEnd();
  mStandingDrawn = true;
}

Image Show::picture(float seconds) { return picture({viewAt(seconds), seconds, mSettings.width, mSettings.height}); }

Image Show::picture(const Shot &shot) {
  const Pose pose = poseAt(mScene, mAnimation, shot.seconds);
  const Vec2 size(shot.width, shot.height);
  rcViewport(0, 0, shot.width, shot.height);
  setView(shot.view, float(mSettings.width) / float(mSettings.height), shot.sample / size);
  setLights(mScene, pose, mLightView.value_or(shot.view), mBounds, mSettings.lighting);
  const auto start = std::chrono::steady_clock::now();
  if (!mStandingDrawn) drawStanding(pose);
  if (mMovingDrawn != shot.seconds) mModel.draw(pose, mMoving, Model::Part::Moving);
  mMovingDrawn = shot.seconds;
  checkErrors("drawing the model");
  mStatistics.buildSeconds = secondsSince(start);
  const int rows = shot.rows > 0 ? shot.rows : shot.height;
  (rows < shot.height ? rcEnable : rcDisable)(RC_SCISSOR_TEST);
  rcScissor(0, shot.row, shot.width, rows);
  const auto traceStart = std::chrono::steady_clock::now();
  rcFinish();
  mStatistics.traceSeconds = secondsSince(traceStart);
  mStatistics.triangles = integerOf(RC_FRAME_TRIANGLES);
  mStatistics.skipped = integerOf(RC_FRAME_TRIANGLES_SKIPPED);
  mStatistics.rays = integerOf(RC_FRAME_RAYS);
  return mTarget.picture(0, shot.row, shot.width, rows);
}

std::optional<Pick> Show::pick(Shot shot, int x, int y) {
  shot.row = y;
  shot.rows = 1;
  picture(shot);
  RCfloat distance = -1, material = 0;
  rcReadRaysRCX(x, y, 1, 1, RC_RAY_DISTANCE, &distance);
  rcReadRaysRCX(x, y, 1, 1, RC_RAY_MATERIAL, &material);
  checkErrors("picking");
  if (distance < 0) return std::nullopt;
  const Vec2 place = Vec2(x, y) / Vec2(shot.width, shot.height);
  const Sight sight = sightThrough(shot.view, float(mSettings.width) / float(mSettings.height), place);
  return Pick{materialName(RCuint(material)), distance, sight.from + distance * sight.direction};
}

void Show::resize(int width, int height) {
  mTarget.resize(width, height);
  mSettings.width = width;
  mSettings.height = height;
}

std::string Show::materialName(RCuint name) const {
  const std::string own = mModel.materialName(name);
  return own.empty() ? mStage.materialName(name) : own;
}

}  // namespace rc::tool
