// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fork.h: what a program's fork() leaves of us in the child: memory as it was, one thread, and locks that nobody lets
// go of any more. Ours are free there: fork() waits until they are, so that it never meets a call half done.
#pragma once

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

  void lock() { mMutex->lock(); }
  bool try_lock() { return mMutex->try_lock(); }
  void unlock() { mMutex->unlock(); }

 private:
  std::shared_ptr<std::recursive_mutex> mMutex;
};

// This process is about to have threads of ours.
void noteThreads();

// Whether it is the child of a process that had some: they do not exist here, though those who manage them think so.
// All work is then done by the thread that asks for it.
bool threadsLostInFork();

}  // namespace rc
