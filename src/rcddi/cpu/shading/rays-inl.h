// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rays-inl.h: units/ray_generation.h for lanes: primary rays of the pixels of a tile.
// In: SceneView, Tile, TilePixels.  Out: RayQueue.  Next: kernels/group-inl.h
#if defined(RAYCORE_SHADING_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_RAYS_INL
#undef RAYCORE_SHADING_RAYS_INL
#else
#define RAYCORE_SHADING_RAYS_INL
#endif

#include "rcddi/cpu/shading/lanes-inl.h"
#include "rchal/tile.h"
#include "rchal/units/ray_generation.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Positions of pixels in the camera's window.
class Window {
 public:
  Window(const hal::CameraView &camera, const hal::Tile &tile, const hal::PixelSample &sample)
      : mX{camera.left, camera.width, static_cast<float>(camera.columns), sample.place.x, tile.column},
        mY{camera.bottom, camera.height, static_cast<float>(camera.rows), sample.place.y, tile.row} {}

  F x(I column) const { return mX.at(column); }  // within the tile
  F y(I row) const { return mY.at(row); }

 private:
  struct Axis {
    float start, size, count, offset;
    int first;

    HWY_INLINE F at(I inTile) const {
      const F pixel = hn::ConvertTo(FTag(), hn::Add(hn::Set(ITag(), first), inTile));
      return hn::Add(all(start), hn::Div(hn::Mul(all(size), hn::Add(pixel, all(offset))), all(count)));
    }
  };

  Axis mX, mY;
};

// The same for tiles of whole blocks, whose columns and rows are looked at once: two divisions take as long as all else
// that a direction needs.
class BlockWindow {
 public:
  static constexpr int kBlock = hal::TilePixels::kBlock, kMost = 64;
  static_assert(kBlock == 4);  // floats in 128 bits

  static bool holds(const hal::TilePixels &pixels) {
    return pixels.areWholeBlocks() && std::max(pixels.columns(), pixels.rows()) <= kMost;
  }
  BlockWindow(const Window &window, const hal::TilePixels &pixels) {
    const ITag di;
    const auto from = [&](int i) HWY_ATTR { return hn::BitCast(di, countFrom(UTag(), static_cast<uint32_t>(i))); };
    const int step = static_cast<int>(lanes());
    for (int i = 0; i < pixels.columns(); i += step) hn::StoreU(window.x(from(i)), FTag(), mX + i);
    for (int i = 0; i < kBlock * pixels.rows(); i += step) {
      hn::StoreU(window.y(hn::ShiftRight<2>(from(i))), FTag(), mY + i);
    }
  }

  // Of the pixels of a vector, the first of which this is.
  F x(int column) const { return hn::LoadDup128(FTag(), mX + column); }
  F y(int row) const { return hn::LoadU(FTag(), mY + kBlock * row); }

 private:
  alignas(64) float mX[kMost + kMostLanes];
  alignas(64) float mY[kBlock * kMost];  // a row's once for each column of a block
};

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

// x(i), y(i): where the pixels from i on are in the window. rays: as many as there are have the common columns of this
// frame's.
template <class X, class Y>
HWY_INLINE void generateRays(const hal::CameraView &camera, const hal::RayItem &one, X &&x, Y &&y,
                             hal::RayQueue &rays) {
  const V3 toWindow = all(camera.back * camera.near);
  for (size_t i = 0; i < rays.size(); i += lanes()) {
    const V3 right = x(i) * all(camera.right), up = y(i) * all(camera.up);
    store(all(one.coneSpread), i, rays.coneSpread);
    if (camera.parallel) {
      store(all(one.ray.direction), i, rays.direction);
      store(all(camera.eye) + right + up - toWindow, i, rays.origin);
      store(all(one.coneWidth), i, rays.coneWidth);
    } else {
      store(directionOf(right + up - toWindow, all(-camera.back)), i, rays.direction);
    }
  }
}

HWY_INLINE void generateRays(const hal::SceneView &scene, const hal::Tile &tile, const hal::TilePixels &pixels,
                             hal::PixelSample sample, hal::RayQueue &rays) {
  const hal::RayItem one = hal::primaryRay(scene.camera, tile.column, tile.row, sample);
  const size_t before = rays.size();
  rays.resize(pixels.size());
  if (before < rays.size()) fillCommonColumns(one, scene.ignorable, before, rays);
  const int32_t *const columns = pixels.column.data(), *const rows = pixels.row.data();
  const Window window(scene.camera, tile, sample);
  if (BlockWindow::holds(pixels)) {
    const BlockWindow blocks(window, pixels);
    generateRays(
        scene.camera, one, [&](size_t i) HWY_ATTR { return blocks.x(columns[i]); },
        [&](size_t i) HWY_ATTR { return blocks.y(rows[i]); }, rays);
  } else {
    generateRays(
        scene.camera, one, [&](size_t i) HWY_ATTR { return window.x(hn::LoadU(ITag(), columns + i)); },
        [&](size_t i) HWY_ATTR { return window.y(hn::LoadU(ITag(), rows + i)); }, rays);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
