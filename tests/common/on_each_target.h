// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// on_each_target.h: the kernels of the cpu device on each instruction set.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdlib>

#include "common/ray_columns.h"

namespace rc::test {

// How many rays slow tests use for each of their cases: RAYCORE_TEST_RAYS, if it is set.
inline size_t raysFromEnvironment(size_t otherwise) {
  const char *text = std::getenv("RAYCORE_TEST_RAYS");
  return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

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
