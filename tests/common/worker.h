// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// worker.h: a thread that does one thing after the other, each when it is told to.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace rc::test {

class Worker {
 public:
  Worker() : mThread([this] { loop(); }) {}
  ~Worker() {
    start(nullptr);
    mThread.join();
  }

  void start(std::function<void()> task) {
    const std::lock_guard lock(mMutex);
    mTask = std::move(task);
    mBusy = true;
    mChanged.notify_all();
  }
  void await() {
    std::unique_lock lock(mMutex);
    mChanged.wait(lock, [&] { return !mBusy; });
  }
  void run(std::function<void()> task) {
    start(std::move(task));
    await();
  }

 private:
  void loop() {
    std::unique_lock lock(mMutex);
    for (bool on = true; on;) {
      mChanged.wait(lock, [&] { return mBusy; });
      on = mTask != nullptr;
      if (on) mTask();
      mBusy = false;
      mChanged.notify_all();
    }
  }

  std::mutex mMutex;
  std::condition_variable mChanged;
  std::function<void()> mTask;
  bool mBusy = false;
  std::thread mThread;
};

}  // namespace rc::test
