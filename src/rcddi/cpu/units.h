// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// units.h: how the cpu device does the work of the units for a tile: queues to streams of rays, and to vectors of hits.
// In: queues.  Out: queues, sums, the picture.  Next: rcddi/cpu/trace.h, rcddi/cpu/shade.h
#pragma once

#include <algorithm>
#include <vector>

#include "rcddi/cpu/shade.h"
#include "rcddi/cpu/trace.h"

namespace rc::ddi::cpu {

// A point as the origin of all rays of a group; written anew only if it has moved.
class OneOrigin {
 public:
  std::array<const float *, 3> columns(const Vec3 &point) {
    if (point != mPoint) write(point);
    return {mColumns[0], mColumns[1], mColumns[2]};
  }

 private:
  void write(const Vec3 &point) {
    mPoint = point;
    for (int axis = 0; axis < 3; ++axis) std::ranges::fill(mColumns[axis], point[axis]);
  }

  Vec3 mPoint{0};
  alignas(64) float mColumns[3][RayStream::kGroup] = {};
};

// One for each worker; its memory is used again from tile to tile.
class CpuUnits {
 public:
  static void generate(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
                       hal::PixelSample sample, hal::RayQueue &rays) {
    cpu::generate(scene, tile, pixels, sample, rays);
  }
  static void closestHits(const hal::SceneView &scene, hal::RayQueue &rays, bool primary, hal::HitQueue &hits);
  static void shade(const hal::SceneView &scene, const hal::RayQueue &rays, const hal::HitQueue &hits,
                    const hal::Outputs &out) {
    cpu::shade(scene, rays, hits, out);
  }
  void addVisible(const hal::SceneView &scene, size_t light, hal::ShadowQueue &shadows, const hal::PixelSums &sums);
  static void store(const hal::SceneView &scene, const hal::Target &target, const hal::Tile &tile,
                    const hal::TilePixels &pixels, const hal::PixelSums &sums) {
    cpu::store(scene, target, tile, pixels, sums);
  }

 private:
  RayStream streamOf(const hal::SceneView &scene, size_t place, hal::ShadowQueue &shadows);
  void addFiltered(const hal::SceneView &scene, const hal::LightRow &light, const hal::ShadowQueue &shadows,
                   uint32_t ray, const hal::PixelSums &sums) const;

  std::vector<OneOrigin> mLights;   // that send shadow rays
  hal::Column<uint8_t> mBlocked;    // by shadow ray
  hal::Column<uint32_t> mFiltered;  // those that cross filters alone
  FilterHits mFilters;
};

}  // namespace rc::ddi::cpu
