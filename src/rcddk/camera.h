// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// camera.h: eye and window, from which primary rays leave. No matrix is involved. [spec 3.1; G 2]
#pragma once

#include <algorithm>
#include <cmath>

#include "rchal/scene_view.h"

namespace rc::ddk {

struct Window {
  double left, right, bottom, top, near;
  bool parallel = false;  // rays do not leave one eye but run side by side [rcOrtho]

  static Window perspective(double fovyDegrees, double aspect, double near) {
    const double halfHeight = near * std::tan(glm::radians(fovyDegrees) / 2);
    return {-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight, near};
  }

  // Rays through a window, twice as far and twice as large, are the same: one as near as 1e-30 becomes one whose
  // squares are within float. A power of two, which changes no bit of them. Parallel rays begin at the window itself.
  double scale() const {
    if (parallel) return 1;
    const int exponent = std::ilogb(std::max({near, std::abs(right - left), std::abs(top - bottom)}));
    return std::exp2(-std::clamp(exponent, -1000, 1000));
  }
};

struct Camera {
  Vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  Window window = Window::perspective(60, 800.0 / 480.0, 0.1);

  // columns, rows: size of the viewport. centred: only the size of the window counts, not its place.
  hal::CameraView view(int columns, int rows, bool centred) const {
    const double width = window.right - window.left, height = window.top - window.bottom;
    const double scale = window.scale();
    hal::CameraView view{eye, right, up, back};
    view.left = static_cast<float>(scale * (centred ? -width / 2 : window.left));
    view.bottom = static_cast<float>(scale * (centred ? -height / 2 : window.bottom));
    view.width = static_cast<float>(scale * width);
    view.height = static_cast<float>(scale * height);
    view.near = static_cast<float>(scale * window.near);
    view.columns = columns;
    view.rows = rows;
    view.parallel = window.parallel;
    return view;
  }
};

}  // namespace rc::ddk
