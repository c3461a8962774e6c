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

struct Statistics {
  int triangles = 0, skipped = 0, rays = 0;
  double buildSeconds = 0, traceSeconds = 0;
};

class Show {
 public:
  Show(Scene scene, ShowSettings settings);

  Image picture(float seconds);
  // The next picture is made as if it were the first.
  void touch() { mStandingDrawn = false; }
  const Statistics &statistics() const { return mStatistics; }
  const Scene &scene() const { return mScene; }
  int animation() const { return mAnimation; }
  // Of all that moves, at every moment of the animation that was looked at.
  const Bounds &bounds() const { return mBounds; }

 private:
  View viewAt(const Pose &pose) const;
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
  Statistics mStatistics;
};

}  // namespace rc::tool
