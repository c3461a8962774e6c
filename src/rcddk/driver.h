// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// driver.h: state and scene to a SceneView, and that to the device: rcFinish lands here. [spec 1]
// In: FrameState, Scene.  Out: the picture in the Target, FrameStats.  Next: rchal/device.h
#pragma once

#include <functional>
#include <span>

#include "rcddk/camera.h"
#include "rcddk/frame_stats.h"
#include "rcddk/light.h"
#include "rcddk/ray_probe.h"
#include "rcddk/scene.h"
#include "rchal/device.h"

namespace rc::ddk {

// What of the state a frame depends on, besides the scene.
struct FrameState {
  hal::CameraView camera;
  Rgb clearColor{0};
  std::span<const Material> materials;  // by name
  std::span<const Light> lights;
  bool lighting = false;
  Vec3 defaultLight{0};  // where the light is that shines when no other does
  bool shadows = true, colourShadow = true;
  bool mipmaps = true;
  int maxBounces = 10;
  int samples = 1;
  bool adaptive = false;
  bool measure = false;  // where the time goes
  float minWeight = 0;
  Rgb globalAmbient{0};
  hal::Fog fog;
  std::optional<hal::PixelRect> scissor;
  uint32_t writeMask = ~0u;
  std::optional<AccelKind> accelKind;  // instead of the process's
};

class Driver {
 public:
  // A device that does not exist is reported, and "cpu" is taken.
  explicit Driver(const Settings &settings);

  AccelKind accelKind() const { return mAccelKind; }
  const Workers &workers() const { return mWorkers; }

  FrameStats trace(const FrameState &state, Scene &scene, const hal::Target &target);
  // The primary rays of the pixels, column and row from the lower left of the viewport, for the scene as it was traced
  // last. take is called on any thread.
  void probe(const FrameState &state, const Scene &scene, const hal::PixelRect &part,
             const std::function<void(int column, int row, const RayAnswer &answer)> &take);

 private:
  AccelKind mAccelKind;
  Workers mWorkers;
  std::unique_ptr<hal::Device> mDevice;
};

}  // namespace rc::ddk
