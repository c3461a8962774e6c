// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The ref device: each pixel by itself and each triangle tried for each ray, on the calling thread. It uses no
// acceleration structure and no tiles, so that it can say whether those that do are right.
#include "rcddi/ref/device.h"

#include "rchal/tile_tracer.h"

namespace rc::ddi::ref {
namespace {

using namespace rc::hal;

class RefDevice final : public Device {
 public:
  std::string_view name() const override { return "ref"; }

  RayCounts trace(const SceneView &scene, const Target &target) override {
    const SceneView plain = withoutStructures(scene);
    clearOutsideViewport(plain, target);
    const PixelRect part = tracedPart(plain, target);
    TileTracer<> tracer(1);
    for (int row = part.row; row < part.row + part.rows; ++row) {
      for (int column = part.column; column < part.column + part.columns; ++column) {
        tracer.trace(plain, {column, row, 1, 1}, target);
      }
    }
    return tracer.counts();
  }

  void intersect(const SceneView &scene, std::span<const Ray> rays, std::span<Hit> hits) override {
    const SceneView plain = withoutStructures(scene);
    for (size_t i = 0; i < rays.size(); ++i) hits[i] = closestHit(plain, rays[i]);
  }

 private:
  static SceneView withoutStructures(const SceneView &scene) {
    SceneView plain = scene;
    for (GeometryView &geometry : plain.geometry) geometry.accel = {};
    return plain;
  }
};

}  // namespace

std::unique_ptr<Device> createDevice(const Workers &) { return std::make_unique<RefDevice>(); }

}  // namespace rc::ddi::ref
