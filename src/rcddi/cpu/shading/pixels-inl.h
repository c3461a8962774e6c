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

// All columns but origin and direction are the same for all rays of a camera; hal::primaryRay() tells them.
HWY_INLINE void generateRays(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
                             hal::PixelSample sample, hal::RayQueue &rays) {
  const FTag d;
  const UTag du;
  const hal::CameraView &camera = scene.camera;
  rays.resize(pixels.size());
  const hal::RayItem one = hal::primaryRay(camera, tile.column, tile.row, sample);
  for (size_t i = 0; i < pixels.size(); i += lanes()) {
    const F x =
        windowPosition(camera.left, camera.width, tile.column, sample.place.x, camera.columns, &pixels.column[i]);
    const F y = windowPosition(camera.bottom, camera.height, tile.row, sample.place.y, camera.rows, &pixels.row[i]);
    const V3 inWindow = x * all(camera.right) + y * all(camera.up);
    const V3 before = all(camera.back * camera.near);
    V3 origin = all(camera.eye), direction = all(-camera.back);
    if (camera.parallel) {
      origin = origin + x * all(camera.right) + y * all(camera.up) - before;
    } else {
      direction = directionOf(inWindow - before, direction);
    }
    const auto store = [&](const V3 &value, hal::VectorsOfQueue &column) HWY_ATTR {
      hn::StoreU(value.x, d, &column.x[i]);
      hn::StoreU(value.y, d, &column.y[i]);
      hn::StoreU(value.z, d, &column.z[i]);
    };
    store(origin, rays.origin);
    store(direction, rays.direction);
    store(all(one.weight), rays.weight);
    hn::StoreU(all(one.after.t), d, &rays.afterT[i]);
    hn::StoreU(hn::Set(du, one.after.primitive), du, &rays.afterPrimitive[i]);
    hn::StoreU(hn::Zero(du), du, &rays.afterSeen[i]);
    hn::StoreU(hn::Zero(du), du, &rays.layers[i]);
    hn::StoreU(all(one.coneWidth), d, &rays.coneWidth[i]);
    hn::StoreU(all(one.coneSpread), d, &rays.coneSpread[i]);
    hn::StoreU(all(one.travelled), d, &rays.travelled[i]);
    hn::StoreU(all(scene.ignorable), d, &rays.tolerance[i]);
    hn::StoreU(countFrom(du, i), du, &rays.pixel[i]);
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
