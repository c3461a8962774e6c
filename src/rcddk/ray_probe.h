// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_probe.h: one primary ray by itself: what it meets, and what finding it cost. [RC_RCX_ray_queries]
// In: SceneView, a pixel.  Out: RayAnswer.
//
// The scalar unit walks the structure, so that the counts are those of one ray by itself. The cpu device's kernels
// share tests of boxes among neighbouring rays and do less.
#pragma once

#include "rchal/scene_view.h"

namespace rc::ddk {

struct RayAnswer {
  float distance = -1;     // from where the ray starts; below 0: it meets nothing
  int32_t material = -1;   // name; 0: a draw without a material object; -1: nothing
  uint32_t boxes = 0;      // of a BVH's children, or planes of a KD-tree's nodes, that were tested
  uint32_t triangles = 0;  // that were tested
};

// The ray of a picture with one sample a pixel. Surfaces that are not there for it are passed: culled sides, failed
// alpha tests, texels without opacity.
RayAnswer probePixel(const hal::SceneView &scene, int column, int row);

}  // namespace rc::ddk
