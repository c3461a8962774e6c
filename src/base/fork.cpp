// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/fork.h"

#include <pthread.h>

#include <atomic>
#include <cstdlib>
#include <vector>

namespace rc {
namespace {

using Mutexes = std::vector<std::shared_ptr<std::recursive_mutex>>;

constinit std::atomic<bool> sHaveThreads = false, sGone = false;

// Every lock of the process that still has an owner.
struct Registry {
  std::mutex mutex;
  std::vector<std::weak_ptr<std::recursive_mutex>> all;

  Mutexes alive() const {
    Mutexes found;
    for (const auto &weak : all) {
      if (auto strong = weak.lock()) found.push_back(std::move(strong));
    }
    return found;
  }
  bool holds(const Mutexes &known) const { return alive() == known; }
};

// Never destroyed: contexts may outlive static objects.
Registry &registry() {
  static auto &registry = *new Registry;
  return registry;
}

Mutexes &heldForFork() {
  static auto &held = *new Mutexes;
  return held;
}

void unlockFirst(const Mutexes &mutexes, size_t count) {
  while (count > 0) mutexes[--count]->unlock();
}

bool tryLockAll(const Mutexes &mutexes) {
  for (size_t i = 0; i < mutexes.size(); ++i) {
    if (mutexes[i]->try_lock()) continue;
    unlockFirst(mutexes, i);
    // Waits for its owner without keeping anyone else waiting.
    const std::lock_guard wait(*mutexes[i]);
    return false;
  }
  return true;
}

// Held from before fork() until after it.
std::mutex &gate() {
  static auto &gate = *new std::mutex;
  return gate;
}

// Ends with all locks, the gate's and the registry's own in hand.
void takeAll() {
  Registry &known = registry();
  for (;;) {
    Mutexes mutexes;
    {
      const std::lock_guard lock(known.mutex);
      mutexes = known.alive();
    }
    if (!tryLockAll(mutexes)) continue;
    known.mutex.lock();
    if (known.holds(mutexes)) {
      heldForFork() = std::move(mutexes);
      return;
    }
    known.mutex.unlock();
    unlockFirst(mutexes, mutexes.size());
  }
}

void letGo() {
  registry().mutex.unlock();
  unlockFirst(heldForFork(), heldForFork().size());
  heldForFork().clear();
}

// The thread has another number here: what it locked it may not unlock. All begin anew.
void inChild() {
  new (&registry().mutex) std::mutex;
  for (const auto &mutex : heldForFork()) new (mutex.get()) std::recursive_mutex;
  heldForFork().clear();
  new (&gate()) std::mutex;
  if (sHaveThreads) sGone = true;
}

}  // namespace

constinit std::atomic<bool> ForkMutex::sForking = false;
constinit thread_local int ForkMutex::tHeld = 0;

void ForkMutex::waitForFork() { const std::lock_guard wait(gate()); }

void ForkMutex::watchForks() {
  static const int watched = pthread_atfork(
      [] {
        gate().lock();
        sForking = true;
        takeAll();
      },
      [] {
        sForking = false;
        letGo();
        gate().unlock();
      },
      [] {
        sForking = false;
        inChild();
      });
  static_cast<void>(watched);
}

ForkMutex::ForkMutex() : mMutex(std::make_shared<std::recursive_mutex>()) {
  watchForks();
  Registry &known = registry();
  const std::lock_guard lock(known.mutex);
  known.all.push_back(mMutex);
}

ForkMutex::~ForkMutex() {
  mMutex = nullptr;  // fork() may still hold it
  Registry &known = registry();
  const std::lock_guard lock(known.mutex);
  std::erase_if(known.all, [](const auto &weak) { return weak.expired(); });
}

void noteThreads() {
  ForkMutex::watchForks();
  sHaveThreads = true;
  // Before the end of what was there before, oneTBB.
  static const int watched = std::atexit([] { sGone = true; });
  static_cast<void>(watched);
}

bool threadsAreGone() { return sGone.load(std::memory_order_relaxed); }

}  // namespace rc
