// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The null device: what a frame costs without tracing it. Every pixel gets the clear colour.
#include "rcddi/null/device.h"

#include "rchal/framebuffer.h"

namespace rc::ddi::null {
namespace {

using namespace rc::hal;

class NullDevice final : public Device {
 public:
  std::string_view name() const override { return "null"; }

  RayCounts trace(const SceneView &scene, const Target &target) override {
    clear(scene, target, writtenPart(scene, target));
    return {};
  }

  void intersect(const SceneView &, std::span<const Ray>, std::span<Hit> hits) override {
    std::fill(hits.begin(), hits.end(), Hit{});
  }
};

}  // namespace

std::unique_ptr<Device> createDevice(const Workers &) { return std::make_unique<NullDevice>(); }

}  // namespace rc::ddi::null
