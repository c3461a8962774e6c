// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rchal/framebuffer.h"

namespace rc::hal {

PixelRect common(const PixelRect &a, const PixelRect &b) {
  const auto end = [](int first, int count) { return int64_t{first} + count; };
  const int column = std::max(a.column, b.column), row = std::max(a.row, b.row);
  const int64_t columns = std::min(end(a.column, a.columns), end(b.column, b.columns)) - column;
  const int64_t rows = std::min(end(a.row, a.rows), end(b.row, b.rows)) - row;
  if (columns <= 0 || rows <= 0) return {};
  return {column, row, static_cast<int>(columns), static_cast<int>(rows)};
}

void clear(const SceneView &scene, const Target &target, const PixelRect &part) {
  const uint32_t colour = packColour(scene.clearColor, target.rgb565);
  for (int row = part.row; row < part.row + part.rows; ++row) {
    for (int column = part.column; column < part.column + part.columns; ++column) {
      store(pixelAt(target, column, row), colour, scene.writeMask);
    }
  }
}

PixelRect writtenPart(const SceneView &scene, const Target &target) {
  const PixelRect all{0, 0, target.width, target.height};
  return scene.scissor ? common(all, *scene.scissor) : all;
}

PixelRect tracedPart(const SceneView &scene, const Target &target) {
  return common(writtenPart(scene, target), {0, 0, scene.camera.columns, scene.camera.rows});
}

void clearOutsideViewport(const SceneView &scene, const Target &target) {
  const int columns = scene.camera.columns, rows = scene.camera.rows;
  const PixelRect written = writtenPart(scene, target);
  const PixelRect right{columns, 0, target.width, std::min(rows, target.height)};
  const PixelRect above{0, rows, target.width, target.height};
  clear(scene, target, common(written, right));
  clear(scene, target, common(written, above));
}

}  // namespace rc::hal
