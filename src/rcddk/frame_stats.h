// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// frame_stats.h: what a traced frame consisted of: the line that says why a picture is black.
#pragma once

#include <string>

#include "rchal/device.h"

namespace rc::ddk {

// Triangles of draw calls that are not in the scene, by reason.
struct SkippedTriangles {
  size_t degenerate = 0;  // no area
  size_t notFinite = 0;   // a coordinate is infinite or not a number
  size_t noData = 0;      // beyond the end of a buffer object
  size_t clipped = 0;     // wholly behind a clip plane: as the program wants it, so all() leaves them out

  size_t all() const { return degenerate + notFinite + noData; }
  SkippedTriangles operator+(const SkippedTriangles &other) const {
    return {degenerate + other.degenerate, notFinite + other.notFinite, noData + other.noData, clipped + other.clipped};
  }
};

struct FrameStats {
  int width = 0, height = 0;
  size_t staticTriangles = 0, dynamicTriangles = 0;
  SkippedTriangles skipped;
  size_t emptyDraws = 0;  // draw calls without a vertex array, or with an array that has no memory
  size_t lights = 0;
  bool defaultLight = false;  // it is the only one
  hal::RayCounts rays;
  double transformMilliseconds = 0;  // of the draw calls since the last frame
  double buildMilliseconds = 0, traceMilliseconds = 0;
  double presentMilliseconds = 0;  // of the frame before
};

// "800 x 480, 12 triangles (8 static, 4 dynamic), ..."
std::string describe(const FrameStats &stats);

}  // namespace rc::ddk
