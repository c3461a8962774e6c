// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// povray.h: a scene's static meshes in POV-Ray 3.7, with the same camera, light and materials.
#pragma once

#include "frames/scenes.h"

namespace rc::bench {

struct PovRayTimes {
  double milliseconds = 0;  // of tracing alone, as it says itself; 0: it could not be run
  double rays = 0;          // without those for shadows
};

void writePovRay(const std::string &path, const FrameScene &scene, int width, int height);

// Traces what writePovRay wrote, without antialiasing; the picture, a PNG, is left out if its path is empty.
PovRayTimes runPovRay(const std::string &program, const std::string &path, const std::string &picture, int width,
                      int height, int threads);

}  // namespace rc::bench
