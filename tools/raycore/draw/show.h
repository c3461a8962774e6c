// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// show.h: a model with camera, lights and surroundings: everything that makes a picture.
// In: Scene, Settings, a moment.  Out: a picture, or just the state for one.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "draw/lights.h"
#include "draw/model.h"
#include "draw/stage.h"
#include "draw/target.h"
#include "draw/view.h"

namespace rc::tool {

struct ShowSettings {
  int width = 800, height = 480, samples = 4, bounces = 10;
  std::string camera, animation, background, up;  // empty: chosen by the model
  std::optional<Vec3> eye, lookAt;
  std::optional<Angle> angle;
  float fov = 45;
  Lighting lighting = Lighting::Automatic;
  GroundKind ground = GroundKind::None;
};

// By number or name; -1 for "" and "none". Throws InputError.
int animationNamed(const Scene &scene, const std::string &name);

// One picture of a show, as far as its settings leave it open.
struct Shot {
  View view;
  float seconds = 0;      // of the animation
  int width, height;      // pixels; may be fewer than the target has
  int row = 0, rows = 0;  // part of them that is traced, from the lowest on; 0: all
  Vec2 sample{0};         // place in the pixel
};

struct Statistics {
  int triangles = 0, skipped = 0, rays = 0;
  double buildSeconds = 0, traceSeconds = 0;
};

// What is seen at a pixel.
struct Pick {
  std::string material;
  float distance;
  Vec3 place;
};

class Show {
 public:
  Show(Scene scene, ShowSettings settings);

  // With the settings' camera and size.
  Image picture(float seconds);
  // The rows that are asked for.
  Image picture(const Shot &shot);
  // Of a pixel from the lower left; nothing: only the clear colour is there.
  std::optional<Pick> pick(Shot shot, int x, int y);
  // Of the settings' camera.
  View viewAt(float seconds) const { return viewOf(poseAt(mScene, mAnimation, seconds)); }

  void resize(int width, int height);
  // The studio stays where it is as seen from there, instead of following the viewer.
  void fixLights(const View &view) { mLightView = view; }
  void setFilter(const TextureFilter &filter) const { mModel.setFilter(filter); }
  // What a material of RayCore's is called; empty for none.
  std::string materialName(RCuint name) const;
  // The next picture is made as if it were the first.
  void touch() {
    mStandingDrawn = false;
    mMovingDrawn.reset();
  }
  const Statistics &statistics() const { return mStatistics; }
  const Scene &scene() const { return mScene; }
  int animation() const { return mAnimation; }
  // Of all that moves, at every moment of the animation that was looked at.
  const Bounds &bounds() const { return mBounds; }
  const ShowSettings &settings() const { return mSettings; }
  bool zUp() const { return mZUp; }

 private:
  View viewOf(const Pose &pose) const;
  void drawStanding(const Pose &pose);

  Scene mScene;
  ShowSettings mSettings;
  bool mZUp;
  Background mBackground;
  int mAnimation;
  std::vector<bool> mMoving;
  Bounds mBounds;
  Target mTarget;
  Model mModel;
  Stage mStage;
  bool mStandingDrawn = false;
  std::optional<float> mMovingDrawn;  // the moment at which what moves was drawn last
  std::optional<View> mLightView;
  Statistics mStatistics;
};

}  // namespace rc::tool
