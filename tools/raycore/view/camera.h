// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// camera.h: how a person moves the viewer about a model.
#pragma once

#include "draw/view.h"

namespace rc::tool {

class CameraController {
 public:
  // Starts from a view; lengths of flights follow the size of the model.
  void place(const View &view, const Bounds &bounds, bool zUp);
  const View &view() const { return mView; }

  // About the point that is looked at, radians; up and down end just before the poles.
  void orbit(float across, float up);
  // Turns the head: the eye stays.
  void look(float across, float up);
  // By shares of the picture's height.
  void pan(float right, float up);
  // Towards the point that is looked at; a step is a notch of the wheel.
  void zoom(float steps);
  // way: right, up, forward, each -1 ... 1.
  void fly(const Vec3 &way, float seconds);

 private:
  struct Turn {
    float azimuth, elevation;
  };
  Vec3 right() const { return glm::normalize(glm::cross(mView.up, mView.eye - mView.centre)); }
  Vec3 up() const { return glm::cross(glm::normalize(mView.eye - mView.centre), right()); }
  Turn turnOf(const Vec3 &back) const;
  Vec3 backOf(const Turn &turn) const;
  Vec3 turned(float across, float up) const;
  void move(const Vec3 &way);

  View mView;
  float mRadius = 1;
  Vec3 mPole{0, 1, 0}, mFront{0, 0, 1}, mSide{1, 0, 0};  // the axes that azimuth and elevation are about
};

}  // namespace rc::tool
