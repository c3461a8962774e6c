// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rchal/framebuffer.h"

namespace rc::hal {

Visible visiblePart(const SceneView &scene, const Target &target) {
  return {std::clamp(scene.camera.columns, 0, target.width), std::clamp(scene.camera.rows, 0, target.height)};
}

void clearOutsideViewport(const SceneView &scene, const Target &target) {
  const Visible visible = visiblePart(scene, target);
  const uint32_t clear = packColour(scene.clearColor);
  for (int y = 0; y < target.height; ++y) {
    uint32_t *row = target.pixels + size_t(y) * size_t(target.width);
    const bool crossesViewport = target.height - 1 - y < visible.rows;
    std::fill(row + (crossesViewport ? visible.columns : 0), row + target.width, clear);
  }
}

}  // namespace rc::hal
