// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// stage.h: a scene drawn through the public API into a pbuffer, frame by frame.
#pragma once

#include <RC/rc.h>

#include "frames/offscreen.h"
#include "frames/scenes.h"

namespace rc::bench {

struct FrameTimes {
  double submit = 0, finish = 0;  // milliseconds: the calls that draw; rcFinish, which builds and traces
  double whole() const { return submit + finish; }
};

class Stage {
 public:
  Stage(const FrameScene &scene, int width, int height);

  FrameTimes draw(int frame);
  // Milliseconds a frame of so many from `first` on, all of which are swapped, what the program does to move things
  // included. finishes: each is waited for before the next one is begun.
  double film(int first, int frames, bool finishes);
  double rays() const;  // of the last frame
  void save(const std::string &path) const { mScreen.save(path); }

 private:
  void setUp();
  void deformAll(int frame);
  void submit(int frame) const;
  void drawMesh(const Mesh &mesh, const std::vector<Vec3> &vertices, RCuint material) const;
  RCuint makeMaterial(const Surface &surface) const;

  const FrameScene &mScene;
  Offscreen mScreen;
  RCuint mMovingMaterial = 0;
  std::vector<std::vector<Vec3>> mDeformed;
};

}  // namespace rc::bench
