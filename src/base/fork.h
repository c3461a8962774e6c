// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fork.h: what a program's fork() leaves of us in the child: memory as it was, one thread, and locks that nobody lets
// go of any more. Ours are free there: fork() waits until they are, so that it never meets a call half done. Calls that
// begin meanwhile wait for it, else it might wait for ever.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>

namespace rc {

// A recursive lock that is free in the child of a fork. A thread that forks inside a call, in a callback, keeps it in
// the parent.
class ForkMutex {
 public:
  ForkMutex();
  ~ForkMutex();
  ForkMutex(const ForkMutex &) = delete;
  ForkMutex &operator=(const ForkMutex &) = delete;

  // From now on fork() waits for the locks.
  static void watchForks();

  void lock() {
    letForkPass();
    lockInside();
  }
  // For what others, who hold a lock, wait for.
  void lockInside() {
    mMutex->lock();
    ++tHeld;
  }
  bool try_lock() {
    if (!mMutex->try_lock()) return false;
    ++tHeld;
    return true;
  }
  void unlock() {
    --tHeld;
    mMutex->unlock();
  }

 private:
  // Waits where another thread is about to fork, unless that waits for this one.
  static void letForkPass() {
    if (sForking.load(std::memory_order_relaxed) && tHeld == 0) waitForFork();
  }
  static void waitForFork();

  static constinit std::atomic<bool> sForking;
  static constinit thread_local int tHeld;  // locks of this thread
  std::shared_ptr<std::recursive_mutex> mMutex;
};

// This process is about to have threads of ours.
void noteThreads();

// Whether it is the child of a process that had some: they do not exist here, though those who manage them think so. Or
// it is about to end: oneTBB may have gone, though destructors of globals and other threads still draw. All work is
// then done by the thread that asks for it.
bool threadsAreGone();

}  // namespace rc
