// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The cpu device: tiles of the screen as tasks, a tracer with its queues for each worker. [G 1.2]
#include "rcddi/cpu/device.h"

#include "base/parallel.h"
#include "rchal/frame.h"

namespace rc::ddi::cpu {
namespace {

using namespace rc::hal;

constexpr int kTileSize = 16;  // pixels a side; small enough that a tile's queues stay in the second-level cache
constexpr size_t kBatch = size_t(kTileSize) * kTileSize;

class CpuDevice final : public Device {
 public:
  explicit CpuDevice(int threads) : mWorkers(threads) {}

  std::string_view name() const override { return "cpu"; }

  RayCounts trace(const SceneView &scene, const Target &target) override {
    clearOutsideViewport(scene, target);
    const PixelRect part = tracedPart(scene, target);
    const int across = (part.columns + kTileSize - 1) / kTileSize, down = (part.rows + kTileSize - 1) / kTileSize;
    std::vector<TileTracer<>> tracers(size_t(mWorkers.threads()), TileTracer<>(kBatch));
    mWorkers.forEach(size_t(across) * size_t(down), [&](size_t i, int worker) {
      const int column = int(i) % across * kTileSize, row = int(i) / across * kTileSize;
      const Tile tile{part.column + column, part.row + row, std::min(kTileSize, part.columns - column),
                      std::min(kTileSize, part.rows - row)};
      tracers[size_t(worker)].trace(scene, tile, target);
    });
    RayCounts counts;
    for (const TileTracer<> &tracer : tracers) counts += tracer.counts();
    return counts;
  }

  void intersect(const SceneView &scene, std::span<const Ray> rays, std::span<Hit> hits) override {
    constexpr size_t kBlock = 1024;
    mWorkers.forEach((rays.size() + kBlock - 1) / kBlock, [&](size_t block, int) {
      const size_t end = std::min(rays.size(), (block + 1) * kBlock);
      for (size_t i = block * kBlock; i < end; ++i) hits[i] = closestHit(scene, rays[i]);
    });
  }

 private:
  Workers mWorkers;
};

}  // namespace

std::unique_ptr<Device> createDevice(int threads) { return std::make_unique<CpuDevice>(threads); }

}  // namespace rc::ddi::cpu
