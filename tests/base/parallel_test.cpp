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
    const auto see = [&](size_t i, int worker) {
      if (busy.at(size_t(worker))++ != 0) clash = true;
      ++seen[i];
      --busy[size_t(worker)];
    };
    workers.forEach(seen.size(), see);
    workers.forEach(seen.size(), see, 7);
    EXPECT_FALSE(clash);
    for (int count : seen) EXPECT_EQ(count, 2);
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

TEST(Background, TheJobIsDoneBesideWhatFollows) {
  const Workers workers(2);
  Background background(workers);
  ASSERT_TRUE(background.possible());
  for (int round = 0; round < 20; ++round) {
    std::atomic<bool> goOn = false;
    int sum = 0;
    background.begin([&] {
      goOn.wait(false);
      workers.forEach(100, [&](size_t i, int) { std::atomic_ref(sum) += int(i); });
    });
    // Work of the same threads does not wait for the job.
    std::atomic<int> count = 0;
    workers.forEach(50, [&](size_t, int) { ++count; });
    EXPECT_EQ(count, 50);
    goOn = true;
    goOn.notify_all();
    background.wait();
    EXPECT_EQ(sum, 4950);
    background.wait();
  }
}

TEST(Background, ExceptionsComeBack) {
  const Workers workers(2);
  Background background(workers);
  background.begin([] { throw std::runtime_error("no"); });
  EXPECT_THROW(background.wait(), std::runtime_error);
  int done = 0;
  background.begin([&] { ++done; });
  background.wait();
  EXPECT_EQ(done, 1);
}

TEST(Background, OneThreadDoesItWhenItWaits) {
  const Workers workers(1);
  Background background(workers);
  EXPECT_FALSE(background.possible());
  int done = 0;
  background.begin([&] { ++done; });
  background.wait();
  EXPECT_EQ(done, 1);
}

TEST(Both, RunsBoth) {
  int a = 0, b = 0;
  Workers(2).run([&] { both([&] { a = 1; }, [&] { b = 2; }); });
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b, 2);
}

}  // namespace
}  // namespace rc::test
