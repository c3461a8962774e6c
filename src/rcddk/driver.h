// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// driver.h: a frame to the device: rcFinish lands here. [spec 1]
// In: Frame.  Out: the picture in the Target, FrameStats.  Next: rchal/device.h
#pragma once

#include <functional>

#include "rcddk/frame.h"
#include "rcddk/frame_stats.h"
#include "rcddk/ray_probe.h"
#include "rchal/device.h"

namespace rc::ddk {

class Driver {
 public:
  // A device that does not exist is reported, and "cpu" is taken.
  explicit Driver(const Settings &settings);

  AccelKind accelKind() const { return mAccelKind; }
  const Workers &workers() const { return mWorkers; }

  // build: the structure of what is dynamic, first.
  void trace(Frame &frame, bool build, const hal::Target &target, FrameStats &stats);
  // The primary rays of the pixels, column and row from the lower left of the viewport, for a frame whose structures
  // are built. take is called on any thread.
  void probe(Frame &frame, const hal::PixelRect &part,
             const std::function<void(int column, int row, const RayAnswer &answer)> &take);

 private:
  AccelKind mAccelKind;
  Workers mWorkers;
  std::unique_ptr<hal::Device> mDevice;
};

}  // namespace rc::ddk
