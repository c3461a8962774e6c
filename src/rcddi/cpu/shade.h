// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shade.h: ray generation, shading and packing of pixels, many at a time, in the widest instructions the machine has.
// The geometry of it is that of rchal/units to the last bit; sums may be in another order.
#pragma once

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

// Sums to bytes, times share. bytes: a Column's.
void pack(const hal::PixelSums &sums, size_t count, float share, bool rgb565, uint32_t *bytes);

}  // namespace rc::ddi::cpu
