// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shade.h: ray generation, shading and storing of pixels, many at a time, in the widest instructions the machine has.
// The geometry of it is that of rchal/units to the last bit; sums may be in another order.
#pragma once

#include "rchal/device.h"
#include "rchal/tile.h"
#include "rchal/units/shading.h"

namespace rc::ddi::cpu {

// A ray through each pixel of the tile.
void generate(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
              hal::PixelSample sample, hal::RayQueue &rays);

// Everything that becomes of rays whose nearest hits are known.
void shade(const hal::SceneView &scene, const hal::RayQueue &rays, const hal::HitQueue &hits, const hal::Outputs &out);

// Adds the colours of shadow rays that were not blocked (0) to their pixels. blocked: a Column's.
void addLit(const hal::ShadowQueue &shadows, const uint8_t *blocked, const hal::PixelSums &sums);

// The sums of all pixels of a tile to the picture.
void store(const hal::SceneView &scene, const hal::Target &target, const hal::Tile &tile, const hal::TilePixels &pixels,
           const hal::PixelSums &sums);

}  // namespace rc::ddi::cpu
