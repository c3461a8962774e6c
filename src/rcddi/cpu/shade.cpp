// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shade.cpp: shading once for each instruction set, and the choice among them when the program runs.
#include "rcddi/cpu/shade.h"

#include "base/simd_targets.h"

// Highway compiles this file again for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rcddi/cpu/shade.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "rcddi/cpu/shading/pixels-inl.h"
#include "rcddi/cpu/shading/rays-inl.h"
#include "rcddi/cpu/shading/shade-inl.h"
#include "rcddi/cpu/shading/sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

void generateOn(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
                hal::PixelSample sample, hal::RayQueue &rays) {
  generateRays(scene, tile, pixels, sample, rays);
}

void shadeOn(const hal::SceneView &scene, const hal::RayQueue &rays, const hal::HitQueue &hits,
             const hal::Outputs &out) {
  const bool cones = scene.mipmaps && !scene.textures.empty();
  shadeBatch({scene, rays, hits, out, out.bounces >= scene.maxBounces, cones});
}

void addLitOn(const hal::ShadowQueue &shadows, const uint8_t *blocked, const hal::PixelSums &sums) {
  addUnblocked(shadows, blocked, sums);
}

void storeOn(const hal::SceneView &scene, const hal::Target &target, const hal::Tile &tile,
             const hal::TilePixels &pixels, const hal::PixelSums &sums) {
  storePixels(scene, target, tile, pixels, sums);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rc::ddi::cpu {

HWY_EXPORT(generateOn);
HWY_EXPORT(shadeOn);
HWY_EXPORT(addLitOn);
HWY_EXPORT(storeOn);

void generate(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
              hal::PixelSample sample, hal::RayQueue &rays) {
  HWY_DYNAMIC_DISPATCH(generateOn)(scene, tile, pixels, sample, rays);
}

void shade(const hal::SceneView &scene, const hal::RayQueue &rays, const hal::HitQueue &hits, const hal::Outputs &out) {
  HWY_DYNAMIC_DISPATCH(shadeOn)(scene, rays, hits, out);
}

void addLit(const hal::ShadowQueue &shadows, const uint8_t *blocked, const hal::PixelSums &sums) {
  HWY_DYNAMIC_DISPATCH(addLitOn)(shadows, blocked, sums);
}

void store(const hal::SceneView &scene, const hal::Target &target, const hal::Tile &tile, const hal::TilePixels &pixels,
           const hal::PixelSums &sums) {
  HWY_DYNAMIC_DISPATCH(storeOn)(scene, target, tile, pixels, sums);
}

}  // namespace rc::ddi::cpu
#endif
