// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The cpu device: tiles of the screen as tasks, a tracer with its queues for each worker. [G 1.2]
#include "rcddi/cpu/device.h"

#include "base/parallel.h"
#include "rcddi/cpu/trace.h"
#include "rcddi/cpu/units.h"
#include "rchal/tile_tracer.h"

namespace rc::ddi::cpu {
namespace {

using namespace rc::hal;

// Pixels; as many as the kernels look at together, and few enough that a tile's queues stay in the second-level cache.
constexpr int kTileColumns = 32, kTileRows = 16;
constexpr size_t kBatch = size_t(kTileColumns) * kTileRows;
static_assert(kBatch == RayStream::kGroup);

class CpuDevice final : public Device {
 public:
  explicit CpuDevice(const Workers &workers) : mWorkers(workers) {
    for (int i = 0; i < mWorkers.threads(); ++i) mTracers.emplace_back(kBatch);
  }

  std::string_view name() const override { return "cpu"; }

  RayCounts trace(const SceneView &scene, const Target &target) override {
    clearOutsideViewport(scene, target);
    const PixelRect part = tracedPart(scene, target);
    const int across = (part.columns + kTileColumns - 1) / kTileColumns;
    const int down = (part.rows + kTileRows - 1) / kTileRows;
    for (TileTracer<CpuUnits> &tracer : mTracers) tracer.beginFrame();
    const size_t tiles = size_t(across) * size_t(down);
    const auto trace = [&](size_t i, int worker) {
      const int column = int(i) % across * kTileColumns, row = int(i) / across * kTileRows;
      const Tile tile{part.column + column, part.row + row, std::min(kTileColumns, part.columns - column),
                      std::min(kTileRows, part.rows - row)};
      mTracers[size_t(worker)].trace(scene, tile, target);
    };
    mWorkers.forEach(tiles, trace, tilesTogether(tiles));
    RayCounts counts;
    for (const TileTracer<CpuUnits> &tracer : mTracers) counts += tracer.counts();
    return counts;
  }

  void intersect(const SceneView &scene, std::span<const Ray> rays, std::span<Hit> hits) override {
    mWorkers.forEach((rays.size() + kBatch - 1) / kBatch, [&](size_t block, int) {
      const size_t first = block * kBatch;
      intersectBlock(scene, rays.subspan(first, std::min(kBatch, rays.size() - first)), &hits[first]);
    });
  }

 private:
  static void intersectBlock(const SceneView &scene, std::span<const Ray> rays, Hit *hits) {
    float columns[6][kBatch];
    for (size_t i = 0; i < rays.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        columns[axis][i] = rays[i].origin[axis];
        columns[3 + axis][i] = rays[i].direction[axis];
      }
    }
    for (float *column : columns) RayStream::pad(column, rays.size());
    HitQueue found;
    closestHits(scene, {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}, rays.size()},
                found);
    for (size_t i = 0; i < rays.size(); ++i) hits[i] = found[i];
  }

  // Tiles differ in cost: where there are few for each thread, one at a time keeps all busy to the end. Where there are
  // many, the price of a task is shared.
  size_t tilesTogether(size_t tiles) const {
    constexpr size_t kTasks = 32;  // for each thread, at least
    return std::clamp<size_t>(tiles / (kTasks * mTracers.size()), 1, 2);
  }

  Workers mWorkers;
  std::vector<TileTracer<CpuUnits>> mTracers;  // one for each worker
};

}  // namespace

std::unique_ptr<Device> createDevice(const Workers &workers) { return std::make_unique<CpuDevice>(workers); }

}  // namespace rc::ddi::cpu
