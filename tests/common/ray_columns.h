// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_columns.h: rays as tests and benches have them for the kernels of the cpu device.
#pragma once

#include <span>
#include <vector>

#include "rcddi/cpu/trace.h"

namespace rc::test {

struct Columns {
  std::vector<float> values[6];

  explicit Columns(std::span<const hal::Ray> rays) {
    for (const hal::Ray &ray : rays) {
      for (int axis = 0; axis < 3; ++axis) {
        values[axis].push_back(ray.origin[axis]);
        values[3 + axis].push_back(ray.direction[axis]);
      }
    }
  }
  ddi::cpu::RayStream stream() const {
    return {{values[0].data(), values[1].data(), values[2].data()},
            {values[3].data(), values[4].data(), values[5].data()},
            values[0].size()};
  }
};

}  // namespace rc::test
