// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/driver.h"

#include "base/instruction_set.h"
#include "base/stopwatch.h"

namespace rc::ddk {

Driver::Driver(const Settings &settings) : mAccelKind(settings.accel), mWorkers(settings.threads) {
  limitInstructionSet(settings.instructionSet);
  mDevice = hal::createDevice(settings.device, mWorkers);
  if (mDevice) return;
  log(LogLevel::Warning, "there is no device \"%s\"; \"cpu\" is used", settings.device.c_str());
  mDevice = hal::createDevice("cpu", mWorkers);
}

void Driver::trace(Frame &frame, bool build, const hal::Target &target, FrameStats &stats) {
  const Stopwatch building;
  if (build) frame.scene().buildDynamic(frame.dynamics(), frame.accelKind(), mWorkers);
  stats.buildMilliseconds = building.milliseconds();

  const Stopwatch tracing;
  const hal::SceneView &view = frame.view();
  stats.rays = mDevice->trace(view, target);
  stats.traceMilliseconds = tracing.milliseconds();
  stats.width = target.width;
  stats.height = target.height;
  const GeometrySet &statics = frame.scene().statics(), &dynamics = frame.dynamics();
  stats.staticTriangles = statics.triangles.size();
  stats.dynamicTriangles = dynamics.triangles.size();
  stats.skipped = statics.skipped + dynamics.skipped;
  stats.lights = view.lights.size();
  stats.defaultLight = frame.hasDefaultLight();
}

void Driver::probe(Frame &frame, const hal::PixelRect &part,
                   const std::function<void(int column, int row, const RayAnswer &answer)> &take) {
  const hal::SceneView &view = frame.view();
  mWorkers.forEach(size_t(part.rows), [&](size_t row, int) {
    for (int column = part.column; column < part.column + part.columns; ++column) {
      take(column, part.row + int(row), probePixel(view, column, part.row + int(row)));
    }
  });
}

}  // namespace rc::ddk
