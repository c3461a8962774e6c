// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// on_each_target.h: the kernels of the cpu device on each instruction set.
#pragma once

#include <gtest/gtest.h>

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
  int count = 0;
  forEachTarget([&](const char *name) {
    SCOPED_TRACE(name);
    ++count;
    check();
  });
  EXPECT_GT(count, 0);
}

}  // namespace rc::test
