// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pixels-inl.h: the two ends of a frame for lanes: units/ray_generation.h, and colours to bytes as framebuffer.h has
// it.
#if defined(RAYCORE_SHADING_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_PIXELS_INL
#undef RAYCORE_SHADING_PIXELS_INL
#else
#define RAYCORE_SHADING_PIXELS_INL
#endif

#include "rcddi/cpu/shading/lanes-inl.h"
#include "rchal/framebuffer.h"
#include "rchal/tile.h"
#include "rchal/units/ray_generation.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Position of pixels along one axis of the camera's window.
HWY_INLINE F windowPosition(float start, float size, int first, float offset, int count, const int32_t *inTile) {
  const ITag di;
  const F pixel = hn::ConvertTo(FTag(), hn::Add(hn::Set(di, first), hn::LoadU(di, inTile)));
  const F place = hn::Mul(all(size), hn::Add(pixel, all(offset)));
  return hn::Add(all(start), hn::Div(place, all(static_cast<float>(count))));
}

// What is the same for all rays of a camera, from the rays that have it already on. hal::primaryRay() tells it.
HWY_INLINE void fillCommonColumns(const hal::RayItem &one, float tolerance, size_t from, hal::RayQueue &rays) {
  const size_t count = rays.size();
  const UTag du;
  for (size_t i = from / lanes() * lanes(); i < count; i += lanes()) {
    store(all(one.ray.origin), i, rays.origin);
    store(all(one.weight), i, rays.weight);
    store(all(one.after.t), i, rays.afterT);
    store(hn::Set(du, one.after.primitive), i, rays.afterPrimitive);
    store(hn::Zero(du), i, rays.afterSeen);
    store(hn::Zero(du), i, rays.layers);
    store(all(one.coneWidth), i, rays.coneWidth);
    store(all(one.travelled), i, rays.travelled);
    store(all(tolerance), i, rays.tolerance);
    store(countFrom(du, i), i, rays.pixel);
  }
}

// rays: as many as there are have the common columns of this frame's.
HWY_INLINE void generateRays(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
                             hal::PixelSample sample, hal::RayQueue &rays) {
  const hal::CameraView &camera = scene.camera;
  const hal::RayItem one = hal::primaryRay(camera, tile.column, tile.row, sample);
  const size_t count = pixels.size(), before = rays.size();
  rays.resize(count);
  if (before < count) fillCommonColumns(one, scene.ignorable, before, rays);
  for (size_t i = 0; i < count; i += lanes()) {
    const F x =
        windowPosition(camera.left, camera.width, tile.column, sample.place.x, camera.columns, &pixels.column[i]);
    const F y = windowPosition(camera.bottom, camera.height, tile.row, sample.place.y, camera.rows, &pixels.row[i]);
    const V3 inWindow = x * all(camera.right) + y * all(camera.up);
    const V3 toWindow = all(camera.back * camera.near);
    store(all(one.coneSpread), i, rays.coneSpread);
    if (camera.parallel) {
      store(all(one.ray.direction), i, rays.direction);
      store(all(camera.eye) + x * all(camera.right) + y * all(camera.up) - toWindow, i, rays.origin);
      store(all(one.coneWidth), i, rays.coneWidth);
    } else {
      store(directionOf(inWindow - toWindow, all(-camera.back)), i, rays.direction);
    }
  }
}

HWY_INLINE U byteOf(F colour) {
  const ITag di;
  const F above = onlyWhere(hn::Gt(colour, zero()), hn::Min(colour, all(1)));
  return hn::BitCast(UTag(), hn::Min(hn::ConvertTo(di, hn::Mul(above, all(256))), hn::Set(di, 255)));
}

// As in rchal/framebuffer.h.
HWY_INLINE U roundTo565(U rgba) {
  const auto bits = [](U value, uint32_t mask) HWY_ATTR { return hn::And(value, hn::Set(UTag(), mask)); };
  const U redAndBlue = bits(hn::ShiftRight<5>(rgba), hal::rgb565::kRedAndBlue);
  const U green = bits(hn::ShiftRight<6>(rgba), hal::rgb565::kGreen);
  return hn::Or(bits(rgba, hal::rgb565::kKept), hn::Or(redAndBlue, green));
}

// bytes: has room for a vector behind its end.
HWY_INLINE void packPixels(const hal::PixelSums &sums, size_t count, float share, bool rgb565, uint32_t *bytes) {
  const FTag d;
  const UTag du;
  for (size_t i = 0; i < count; i += lanes()) {
    const V3 colour =
        all(share) * V3{hn::LoadU(d, sums.red + i), hn::LoadU(d, sums.green + i), hn::LoadU(d, sums.blue + i)};
    const U low = hn::Or(byteOf(colour.x), hn::ShiftLeft<8>(byteOf(colour.y)));
    const U high = hn::Or(hn::ShiftLeft<16>(byteOf(colour.z)), hn::Set(du, 0xff000000u));
    const U rgba = hn::Or(low, high);
    hn::StoreU(rgb565 ? roundTo565(rgba) : rgba, du, bytes + i);
  }
}
}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
