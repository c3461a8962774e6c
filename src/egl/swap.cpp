// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/swap.h"

#include <atomic>
#include <cstdlib>

#include "egl/capture.h"

namespace rc::egl {

bool swapBuffers(RenderContext &context, const std::shared_ptr<Surface> &surface) {
  static std::atomic<int> swaps = 0;
  const int frame = ++swaps;
  const Settings &settings = rc::settings();
  if (!settings.capture.empty()) {
    context.api.finish();
    writePicture(captureName(settings.capture, frame), surface->picture());
  }
  context.api.finishAndShow([surface] { surface->present(); });
  surface->noteSwapped();
  if (frame == settings.frames || surface->closeRequested()) {
    context.api.await();
    std::exit(EXIT_SUCCESS);
  }
  return !surface->gone();
}

}  // namespace rc::egl
