// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/sync.h"

#include <chrono>

namespace rc::egl {
namespace {

// Longer waits are for ever: the clock cannot count so far.
constexpr EGLTime kLongest = 1'000'000'000ull * 60 * 60 * 24 * 365;

}  // namespace

bool Sync::signaled() const {
  const std::lock_guard lock(mMutex);
  return mSignaled;
}

void Sync::signal() {
  const std::lock_guard lock(mMutex);
  mSignaled = true;
  mChanged.notify_all();
}

bool Sync::wait(EGLTime timeout) const {
  std::unique_lock lock(mMutex);
  const auto done = [&] { return mSignaled; };
  if (timeout <= kLongest) {
    return mChanged.wait_until(lock, std::chrono::steady_clock::now() + std::chrono::nanoseconds(timeout), done);
  }
  mChanged.wait(lock, done);
  return true;
}

void Fences::add(const std::shared_ptr<Sync> &sync, bool asks) {
  const std::lock_guard lock(mMutex);
  if (asks || mTracing) {
    (asks ? mWaiting : mAsked).push_back(sync);
  } else {
    sync->signal();
  }
}

void Fences::ask() {
  const std::lock_guard lock(mMutex);
  mAsked.insert(mAsked.end(), mWaiting.begin(), mWaiting.end());
  mWaiting.clear();
  mTracing = true;
}

void Fences::pass() {
  const std::lock_guard lock(mMutex);
  for (const std::shared_ptr<Sync> &sync : mAsked) sync->signal();
  mAsked.clear();
  mTracing = false;
}

void Fences::passAll() {
  ask();
  pass();
}

}  // namespace rc::egl
