// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Children of fork(): workers that work without their threads, and locks that are free.
#include "base/fork.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/parallel.h"

namespace rc::test {
namespace {

// Runs body in a child; whether it returned true within half a minute.
template <class Body>
bool succeedsInChild(Body &&body) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(30);
    _exit(body() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status == 0;
}

TEST(Fork, WorkersOfTheParentWorkInTheChild) {
  const Workers workers(4);
  std::atomic<int> done = 0;
  const auto work = [&] {
    done = 0;
    workers.forEach(1000, [&](size_t, int worker) { done += worker >= 0 && worker < 4; });
    workers.run([&] { both([&] { ++done; }, [&] { ++done; }); });
    return done == 1002;
  };
  ASSERT_TRUE(work());
  EXPECT_FALSE(threadsAreGone());
  EXPECT_TRUE(succeedsInChild([&] { return threadsAreGone() && work(); }));
  EXPECT_TRUE(work());
}

TEST(Fork, NewWorkersWorkInTheChildAndItsChild) {
  const auto work = [] {
    const Workers workers(3);
    std::atomic<int> done = 0;
    workers.forEach(100, [&](size_t, int) { ++done; });
    return done == 100;
  };
  ASSERT_TRUE(work());
  EXPECT_TRUE(succeedsInChild([&] { return work() && succeedsInChild(work); }));
}

TEST(Fork, WorkersOfTheParentAreDestroyedInTheChild) {
  auto workers = std::make_unique<Workers>(4);
  workers->forEach(100, [](size_t, int) {});
  EXPECT_TRUE(succeedsInChild([&] {
    workers.reset();
    return true;
  }));
}

TEST(Fork, LocksThatOtherThreadsHoldAreFreeInTheChild) {
  ForkMutex mutex;
  std::atomic<bool> held = false, let = false;
  std::thread owner([&] {
    const std::lock_guard lock(mutex);
    held = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    let = true;
  });
  while (!held) std::this_thread::yield();
  EXPECT_TRUE(succeedsInChild([&] {
    const std::lock_guard lock(mutex), again(mutex);
    return let.load();  // the owner was awaited
  }));
  owner.join();
  EXPECT_TRUE(mutex.try_lock()) << "free in the parent too";
  mutex.unlock();
}

TEST(Fork, AThreadMayForkWithItsOwnLockInHand) {
  ForkMutex mutex;
  const std::lock_guard lock(mutex);
  EXPECT_TRUE(succeedsInChild([&] {
    const std::lock_guard again(mutex);
    return true;
  }));
}

// Locks that come and go, and are taken in different orders, while others fork.
TEST(Fork, ManyThreadsLockWhileOneForks) {
  ForkMutex first, second;
  std::atomic<bool> end = false;
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&, i] {
      while (!end) {
        const std::lock_guard lock(i == 0 ? first : second);
        const ForkMutex own;
      }
    });
  }
  for (int i = 0; i < 30; ++i) {
    EXPECT_TRUE(succeedsInChild([&] {
      const std::lock_guard a(first), b(second);
      return true;
    }));
  }
  end = true;
  for (std::thread &thread : threads) thread.join();
}

}  // namespace
}  // namespace rc::test
