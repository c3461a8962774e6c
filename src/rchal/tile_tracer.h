// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tile_tracer.h: the loop over generations that takes one tile of the screen through the units. [G 1.2]
//   ray generation -> traversal & intersection -> hit point and shading -> shadow rays -> next generation
// In: SceneView, a tile.  Out: pixels of the Target.
//
// There is no recursion: the primary rays of a tile are traced at once, all others wait in two queues for each number
// of bounces. The deepest queue with rays for a batch is served first, which bounds what is waiting: less than two
// batches, or tiles, in each. Colours are summed in an order that depends on the tile alone, so the threads do not
// change the picture.
#pragma once

#include <vector>

#include "base/stopwatch.h"
#include "rchal/framebuffer.h"
#include "rchal/pixel_choice.h"
#include "rchal/tile.h"
#include "rchal/units/ray_generation.h"
#include "rchal/units/shading.h"
#include "rchal/units/shadow.h"
#include "rchal/units/traversal.h"

namespace rc::hal {

// How a device does the work of the units, a batch at a time. This one asks the scalar units, item by item.
struct ScalarUnits {
  // A ray through each pixel of the tile, in their order. rays: those of an earlier tile of the frame, or none.
  static void generate(const SceneView &scene, const Tile &tile, const TilePixels &pixels, PixelSample sample,
                       RayQueue &rays) {
    rays.resize(0);
    for (size_t i = 0; i < pixels.size(); ++i) {
      RayItem item = primaryRay(scene.camera, tile.column + pixels.column[i], tile.row + pixels.row[i], sample);
      item.pixel = static_cast<uint32_t>(i);
      item.tolerance = scene.ignorable;
      rays.push(item);
    }
  }
  // primary: they are those of generate(), so that what these have in common need not be looked for.
  static void closestHits(const SceneView &scene, const RayQueue &rays, bool, HitQueue &hits) {
    for (size_t i = 0; i < rays.size(); ++i) hits.set(i, nextHit(scene, rays.ray(i), rays.after(i), kInfinity));
  }
  static void shade(const SceneView &scene, const RayQueue &rays, const HitQueue &hits, const Outputs &out) {
    for (size_t i = 0; i < rays.size(); ++i) shadeRay(scene, rays[i], hits[i], out);
  }
  // The questions about one of the scene's lights.
  static void addVisible(const SceneView &scene, size_t light, const ShadowQueue &shadows, const PixelSums &sums) {
    const Reach reach = reachOf(scene.lights[light]);
    for (size_t i = 0; i < shadows.size(); ++i) {
      const ShadowItem item = shadows[i];
      sums.add(item.pixel, item.colour * visibility(scene, item.ray, reach));
    }
  }
  // The picture gets the pixels of the tile: of several samples the mean.
  static void store(const SceneView &scene, const Target &target, const Tile &tile, const TilePixels &pixels,
                    const PixelSums &sums) {
    const float share = 1 / static_cast<float>(scene.samples);
    for (size_t i = 0; i < pixels.size(); ++i) {
      uint32_t &pixel = pixelAt(target, tile.column + pixels.column[i], tile.row + pixels.row[i]);
      hal::store(pixel, packColour(sums[i] * share, target.rgb565), scene.writeMask);
    }
  }
};

// What one worker needs to trace tiles; reused from tile to tile.
template <class Units = ScalarUnits>
class TileTracer {
 public:
  explicit TileTracer(size_t batch) : mBatch(batch) {}

  void trace(const SceneView &scene, const Tile &tile, const Target &target) {
    try {
      traceTile(scene, tile, target);
    } catch (...) {  // out of memory: rays that still wait are of no other tile
      dropRays();
      throw;
    }
  }

  const RayCounts &counts() const { return mCounts; }  // of the frame
  void beginFrame() {
    mCounts = {};
    mPrimary.resize(0);
  }

 private:
  void traceTile(const SceneView &scene, const Tile &tile, const Target &target) {
    mPixels.arrange(tile.columns, tile.rows);
    prefetch(tile, target);
    mQueues.resize(std::max(mQueues.size(), kKinds * (size_t(scene.maxBounces) + 2)));
    mShadows.resize(std::max(mShadows.size(), scene.lights.size()));
    if (scene.samples == 1) {
      traceSample(scene, tile, mPixels, {});
    } else {
      mPicture.clear(mPixels.size());
      choosePixels(scene, tile);
      traceSamples(scene, tile);
    }
    Sums &sums = scene.samples == 1 ? mSum : mPicture;
    timed(scene, &UnitTimes::store, [&] { mUnits.store(scene, target, tile, mPixels, sums.view()); });
  }

  // The lines that the picture will be written to.
  static void prefetch(const Tile &tile, const Target &target) {
    constexpr int kLine = 64 / sizeof(uint32_t);
    for (int row = 0; row < tile.rows; ++row) {
      for (int x = 0; x < tile.columns; x += kLine) {
        __builtin_prefetch(&pixelAt(target, tile.column + x, tile.row + row), 1);
      }
    }
  }

  void dropRays() {
    mPrimary.resize(0);
    for (RayQueue &queue : mQueues) queue.resize(0);
    for (ShadowQueue &queue : mShadows) queue.resize(0);
  }

  // By pixel of the tile.
  struct Sums {
    Vec3Column colours;

    PixelSums view() { return {colours.x.data(), colours.y.data(), colours.z.data()}; }
    void clear(size_t count) {
      for (Column<float> *column : {&colours.x, &colours.y, &colours.z}) column->assign(count, 0);
    }
  };

  template <class Work>
  void timed(const SceneView &scene, double UnitTimes::*unit, Work &&work) {
    if (!scene.measure) return work();
    const Stopwatch watch;
    work();
    mCounts.times.*unit += watch.milliseconds() * 1e-3;
  }

  // A ray through each of the pixels; what it brings is in mSum, in their order.
  void traceSample(const SceneView &scene, const Tile &tile, const TilePixels &pixels, PixelSample sample) {
    mSum.clear(pixels.size());
    timed(scene, &UnitTimes::generate, [&] { mUnits.generate(scene, tile, pixels, sample, mPrimary); });
    mCounts.primary += pixels.size();
    traceRays(scene, 0, mPrimary);
    traceGenerations(scene);
  }

  void choosePixels(const SceneView &scene, const Tile &tile) {
    if (!scene.adaptive) return mChoice.chooseAll(mPixels);
    traceSample(scene, tile, mChoice.cornersOf(tile), {});
    mChoice.chooseByCorners(mPixels, mSum.view(), static_cast<float>(scene.samples), mPicture.view());
  }

  // Samples are cut off at 1 one by one: a light in a mirror shall not outshine its edge.
  void traceSamples(const SceneView &scene, const Tile &tile) {
    const PixelSums picture = mPicture.view();
    const TilePixels &chosen = mChoice.chosen();
    for (int sample = 0; sample < scene.samples; ++sample) {
      traceSample(scene, tile, chosen, sampleOf(sample, scene.samples));
      const PixelSums sums = mSum.view();
      for (size_t i = 0; i < chosen.size(); ++i) picture.add(mChoice.placeOf(i), glm::clamp(sums[i], 0.0f, 1.0f));
    }
  }

  void traceGenerations(const SceneView &scene) {
    for (;;) {
      const size_t queue = nextQueue();
      if (queue == mQueues.size()) return;
      traceBatch(scene, queue);
    }
  }

  // The deepest queue with rays for a batch; else the shallowest one with any, so that deeper ones fill.
  size_t nextQueue() const {
    for (size_t deepest = mQueues.size(); deepest-- > 0;) {
      if (mQueues[deepest].size() >= mBatch) return deepest;
    }
    size_t shallowest = 0;
    while (shallowest < mQueues.size() && mQueues[shallowest].size() == 0) ++shallowest;
    return shallowest;
  }

  // Takes the last rays off the queue.
  void traceBatch(const SceneView &scene, size_t queue) {
    mQueues[queue].takeLast(std::min(mQueues[queue].size(), mBatch), mRays);
    traceRays(scene, queue, mRays);
  }

  // queue: that the rays came from; those that go straight on go there again.
  void traceRays(const SceneView &scene, size_t queue, RayQueue &rays) {
    const size_t bounces = queue / kKinds;
    RayQueue *const next = &mQueues[kKinds * (bounces + 1)];
    mHits.resize(rays.size());
    timed(scene, bounces == 0 ? &UnitTimes::primary : &UnitTimes::secondary,
          [&] { mUnits.closestHits(scene, rays, &rays == &mPrimary, mHits); });
    timed(scene, &UnitTimes::shade, [&] {
      mUnits.shade(scene, rays, mHits,
                   {mSum.view(), mShadows, mQueues[queue], next[0], next[1], mCounts, int(bounces)});
    });
    for (size_t light = 0; light < scene.lights.size(); ++light) {
      if (mShadows[light].size() == 0) continue;
      timed(scene, &UnitTimes::shadow, [&] { mUnits.addVisible(scene, light, mShadows[light], mSum.view()); });
      mShadows[light].resize(0);
    }
  }

  size_t mBatch;
  Units mUnits;
  TilePixels mPixels;   // all of the tile
  PixelChoice mChoice;  // of several samples: those of them that get all
  // By number of bounces, of each those that were reflected last and those that were refracted last: they go other
  // ways, and a batch of both would have little in common.
  static constexpr size_t kKinds = 2;
  std::vector<RayQueue> mQueues;
  RayQueue mPrimary;  // of the last tile
  RayQueue mRays;     // the batch of others in hand
  HitQueue mHits;
  std::vector<ShadowQueue> mShadows;  // by light
  Sums mSum, mPicture;
  RayCounts mCounts;
};

}  // namespace rc::hal
