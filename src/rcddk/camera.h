// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// camera.h: eye and window, from which primary rays leave. No matrix is involved. [spec 3.1; G 2]
#pragma once

#include "rchal/scene_view.h"

namespace rc::ddk {

struct Window {
  double left, right, bottom, top, near;
  bool parallel = false;  // rays do not leave one eye but run side by side [rcOrtho]

  static Window perspective(double fovyDegrees, double aspect, double near) {
    const double halfHeight = near * std::tan(glm::radians(fovyDegrees) / 2);
    return {-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight, near};
  }
};

struct Camera {
  Vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  Window window = Window::perspective(60, 800.0 / 480.0, 0.1);

  // columns, rows: size of the viewport. centred: only the size of the window counts, not its place.
  hal::CameraView view(int columns, int rows, bool centred) const {
    const double width = window.right - window.left, height = window.top - window.bottom;
    hal::CameraView view{eye, right, up, back};
    view.left = static_cast<float>(centred ? -width / 2 : window.left);
    view.bottom = static_cast<float>(centred ? -height / 2 : window.bottom);
    view.width = static_cast<float>(width);
    view.height = static_cast<float>(height);
    view.near = static_cast<float>(window.near);
    view.columns = columns;
    view.rows = rows;
    view.parallel = window.parallel;
    return view;
  }
};

}  // namespace rc::ddk
