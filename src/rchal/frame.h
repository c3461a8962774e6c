// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// frame.h: the loop over generations that takes one tile of the screen through the units. [G 1.2]
//   ray generation -> traversal & intersection -> hit point and shading -> shadow rays -> next generation
// In: SceneView, a tile.  Out: pixels of the Target.
//
// There is no recursion: secondary rays wait in one queue for each number of bounces. The deepest queue is
// served first, a batch at a time, which bounds what is waiting: at most two batches for each bounce.
// Colours are summed in an order that depends on the tile alone, so the threads do not change the picture.
#pragma once

#include <vector>

#include "rchal/framebuffer.h"
#include "rchal/units/fog.h"
#include "rchal/units/ray_generation.h"
#include "rchal/units/shading.h"
#include "rchal/units/shadow.h"
#include "rchal/units/traversal.h"

namespace rc::hal {

using Tile = PixelRect;  // of the viewport; small enough for the queues of its rays

// How a device answers questions to the traversal unit. This one asks the scalar unit, ray by ray.
struct ScalarTraversal {
  static void closestHits(const SceneView &scene, const RayQueue &rays, HitQueue &hits) {
    hits.clear();
    for (size_t i = 0; i < rays.size(); ++i) hits.push_back(nextHit(scene, rays.ray(i), rays.after[i], kInfinity));
  }
  static void addVisible(const SceneView &scene, const ShadowQueue &shadows, std::span<Rgb> sum) {
    for (size_t i = 0; i < shadows.size(); ++i) {
      const ShadowItem item = shadows[i];
      sum[item.pixel] += item.colour * visibility(scene, item.ray, item.distance);
    }
  }
};

// What one worker needs to trace tiles; reused from tile to tile.
template <class Traversal = ScalarTraversal>
class TileTracer {
 public:
  explicit TileTracer(size_t batch) : mBatch(batch) {}

  void trace(const SceneView &scene, const Tile &tile, const Target &target) {
    if (mQueues.size() < size_t(scene.maxBounces) + 2) mQueues.resize(size_t(scene.maxBounces) + 2);
    mPicture.assign(size_t(tile.columns * tile.rows), Rgb(0));
    for (int sample = 0; sample < scene.samples; ++sample) {
      mSum.assign(size_t(tile.columns * tile.rows), Rgb(0));
      generatePrimaryRays(scene, tile, samplePosition(sample, scene.samples));
      traceGenerations(scene);
      for (size_t i = 0; i < mSum.size(); ++i) mPicture[i] += glm::clamp(mSum[i], 0.0f, 1.0f);
    }
    const float share = 1.0f / static_cast<float>(scene.samples);
    for (int i = 0; i < tile.columns * tile.rows; ++i) {
      uint32_t &pixel = pixelAt(target, tile.column + i % tile.columns, tile.row + i / tile.columns);
      store(pixel, packColour(mPicture[size_t(i)] * share), scene.writeMask);
    }
  }

  const RayCounts &counts() const { return mCounts; }

 private:
  static constexpr int kBlock = 4;  // pixels a side

  void generatePrimaryRays(const SceneView &scene, const Tile &tile, Vec2 offset) {
    for (int row = 0; row < tile.rows; row += kBlock) {
      for (int column = 0; column < tile.columns; column += kBlock) generateBlock(scene, tile, column, row, offset);
    }
    mCounts.primary += size_t(tile.columns * tile.rows);
  }

  // Pixels that lie beside each other in both directions follow each other in the queue: their rays stay together.
  void generateBlock(const SceneView &scene, const Tile &tile, int column, int row, Vec2 offset) {
    for (int y = row; y < std::min(row + kBlock, tile.rows); ++y) {
      for (int x = column; x < std::min(column + kBlock, tile.columns); ++x) {
        RayItem item = primaryRay(scene.camera, tile.column + x, tile.row + y, offset);
        item.pixel = static_cast<uint32_t>(y * tile.columns + x);
        mQueues[0].push(item);
      }
    }
  }

  void traceGenerations(const SceneView &scene) {
    for (;;) {
      size_t deepest = mQueues.size();
      while (deepest > 0 && mQueues[deepest - 1].size() == 0) --deepest;
      if (deepest == 0) return;
      traceBatch(scene, mQueues[deepest - 1], mQueues[deepest]);
    }
  }

  // Takes the last rays off the queue.
  void traceBatch(const SceneView &scene, RayQueue &queue, RayQueue &next) {
    queue.takeLast(std::min(queue.size(), mBatch), mRays);
    mTraversal.closestHits(scene, mRays, mHits);

    const Outputs out{mSum, mShadows, queue, next, mCounts};
    for (size_t i = 0; i < mRays.size(); ++i) {
      RayItem item = mRays[i];
      if (!mHits[i].found()) {
        mSum[item.pixel] += item.weight * scene.clearColor;
        continue;
      }
      if (item.bounces == 0 && item.after.primitive == kNoPrimitive) ++mCounts.primaryHits;
      mSum[item.pixel] += passFog(scene.fog, item, mHits[i].t);
      Shader(scene, item, mHits[i], out).shade();
    }
    mTraversal.addVisible(scene, mShadows, mSum);
    mShadows.clear();
  }

  size_t mBatch;
  Traversal mTraversal;
  std::vector<RayQueue> mQueues;  // by number of bounces
  RayQueue mRays;                 // the batch in hand
  HitQueue mHits;
  ShadowQueue mShadows;
  std::vector<Rgb> mSum, mPicture;  // by pixel of the tile
  RayCounts mCounts;
};

}  // namespace rc::hal
