// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_generation.h: from a pixel to its primary ray. [spec 3.1; G 2]
// In: CameraView, column, row, sample.  Out: RayItem.  Next: units/traversal.h
//
// The sample of a pixel is its lower left corner; several samples fill the pixel's square.
#pragma once

#include "rchal/queues.h"
#include "rchal/tile.h"

namespace rc::hal {

// One sample lies at the corner. Several form a rank-1 lattice along the golden ratio, about the middle: even in both
// axes and the same in each frame. Together they cover the pixel, so each one's footprint is as much smaller.
inline PixelSample sampleOf(int sample, int samples) {
  if (samples == 1) return {};
  const auto count = static_cast<float>(samples);
  const float place = static_cast<float>(sample) + 0.5f, golden = 0.61803399f * place;
  return {{place / count, golden - std::floor(golden)}, 1 / std::sqrt(count)};
}

// column from the left, row from the bottom of the viewport.
inline RayItem primaryRay(const CameraView &camera, int column, int row, PixelSample sample) {
  const float x =
      camera.left + camera.width * (static_cast<float>(column) + sample.place.x) / static_cast<float>(camera.columns);
  const float y =
      camera.bottom + camera.height * (static_cast<float>(row) + sample.place.y) / static_cast<float>(camera.rows);
  const float pixel = sample.width * std::abs(camera.height) / static_cast<float>(camera.rows);
  RayItem item;
  if (camera.parallel) {
    item.ray = {camera.eye + camera.right * x + camera.up * y - camera.back * camera.near, -camera.back};
    item.coneWidth = pixel;
    item.travelled = camera.near;  // from the plane of the eye
    return item;
  }
  item.ray.origin = camera.eye;
  item.ray.direction = directionOf(camera.right * x + camera.up * y - camera.back * camera.near, -camera.back);
  item.coneSpread = pixel / camera.near;
  return item;
}

}  // namespace rc::hal
