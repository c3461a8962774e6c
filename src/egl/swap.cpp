// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/swap.h"

#include <atomic>
#include <cstdlib>

#include "base/stopwatch.h"
#include "egl/capture.h"

namespace rc::egl {

bool swapBuffers(RenderContext &context, Surface &surface) {
  static std::atomic<int> swaps = 0;
  context.api.finish();
  const int frame = ++swaps;
  const Settings &settings = rc::settings();
  if (!settings.capture.empty()) writePicture(captureName(settings.capture, frame), surface.picture());
  const Stopwatch watch;
  const bool shown = surface.present();
  context.api.notePresented(watch.milliseconds());
  context.api.endFrame();
  if (frame == settings.frames || surface.closeRequested()) std::exit(EXIT_SUCCESS);
  return shown;
}

}  // namespace rc::egl
