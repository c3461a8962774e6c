// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// on_each_target.h: the kernels of the cpu device, called with rays as tests have them, on each instruction set.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdlib>
#include <span>
#include <vector>

#include "rcddi/cpu/trace.h"

namespace rc::test {

// How many rays slow tests use for each of their cases: RAYCORE_TEST_RAYS, if it is set.
inline size_t raysFromEnvironment(size_t otherwise) {
  const char *text = std::getenv("RAYCORE_TEST_RAYS");
  return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

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

// Calls check() with each target alone; the best one afterwards again.
template <class Check>
inline void onEachTarget(Check &&check) {
  const int64_t all = hwy::SupportedTargets();
  int count = 0;
  for (int64_t rest = all; rest != 0; rest &= rest - 1, ++count) {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    SCOPED_TRACE(hwy::TargetName(rest & -rest));
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GT(count, 0);
}

}  // namespace rc::test
