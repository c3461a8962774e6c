// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// overlay.h: what the window says over its picture.
#pragma once

#include <string>
#include <vector>

#include "draw/show.h"
#include "view/playback.h"
#include "view/refinement.h"

namespace rc::tool {

// How fast pictures in motion follow each other.
class MotionMeter {
 public:
  void frame(double seconds);
  double perSecond() const { return mRecent > 0 ? 1 / mRecent : 0; }
  // "moving: 120 frames, 41.3 a second, the slowest took 31 ms"; empty if nothing moved.
  std::string summary() const;

 private:
  int mFrames = 0;
  double mSum = 0, mSlowest = 0, mRecent = 0;
};

// Of the last traced pass, as RayCore tells it.
std::vector<std::string> statisticsLines(const Show &show, const Refinement &refinement, const Playback &playback,
                                         const MotionMeter &motion);

// panel: upper left; message: lower left.
void drawOverlay(Image &image, const std::vector<std::string> &panel, const std::string &message);

}  // namespace rc::tool
