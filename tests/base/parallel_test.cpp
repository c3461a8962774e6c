// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace rc::test {
namespace {

TEST(Workers, EveryIndexOnceAndNoWorkerTwiceAtATime) {
  for (int threads : {1, 2, 7}) {
    const Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    std::vector<int> seen(1000);
    std::vector<std::atomic<int>> busy(static_cast<size_t>(threads));
    std::atomic<bool> clash = false;
    workers.forEach(seen.size(), [&](size_t i, int worker) {
      if (busy.at(size_t(worker))++ != 0) clash = true;
      ++seen[i];
      --busy[size_t(worker)];
    });
    EXPECT_FALSE(clash);
    for (int count : seen) EXPECT_EQ(count, 1);
  }
}

TEST(Workers, AllThreadsOfTheMachineByDefault) { EXPECT_GE(Workers(0).threads(), 1); }

TEST(Workers, ExceptionsComeBack) {
  EXPECT_THROW(Workers(2).forEach(10,
                                  [](size_t i, int) {
                                    if (i == 5) throw std::runtime_error("five");
                                  }),
               std::runtime_error);
}

TEST(Both, RunsBoth) {
  int a = 0, b = 0;
  Workers(2).run([&] { both([&] { a = 1; }, [&] { b = 2; }); });
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b, 2);
}

}  // namespace
}  // namespace rc::test
