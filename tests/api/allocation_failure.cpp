// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/allocation_failure.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace rc::test {
namespace {

constexpr int kNever = -1;
thread_local int tGood = kNever;
thread_local bool tFailed = false;

constinit std::atomic<bool> sCounting = false, sLasting = false, sFailed = false;
constinit std::atomic<int> sGood = 0;
constinit std::atomic<long> sLive = 0;

bool failsHere() {
  if (tGood == kNever || tGood-- != 0) return false;
  return tFailed = true;
}

bool failsAnywhere() {
  if (!sCounting) return false;
  const int good = sGood.fetch_sub(1);
  if (good > 0 || (good < 0 && !sLasting)) return false;
  sFailed = true;
  return true;
}

// std::aligned_alloc wants a whole number of alignments.
void *memoryOf(std::size_t size, std::size_t alignment) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(std::max<std::size_t>(size, 1));
  return std::aligned_alloc(alignment, (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
}

void *allocate(std::size_t size, std::size_t alignment = 1) {
  if (failsHere() || failsAnywhere()) throw std::bad_alloc();
  void *memory = memoryOf(size, alignment);
  if (!memory) throw std::bad_alloc();
  ++sLive;
  return memory;
}

void *allocateOrNull(std::size_t size, std::size_t alignment = 1) noexcept {
  try {
    return allocate(size, alignment);
  } catch (const std::bad_alloc &) {
    return nullptr;
  }
}

void release(void *memory) noexcept {
  if (memory) --sLive;
  std::free(memory);
}

}  // namespace

void failAllocationAfter(int good) {
  tGood = good;
  tFailed = false;
}

void failAnyAllocationAfter(int good, Shortage shortage) {
  sFailed = false;
  sGood = good;
  sLasting = shortage == Shortage::Lasting;
  sCounting = true;
}

bool allocationFailed() {
  tGood = kNever;
  sCounting = false;
  const bool anywhere = sFailed.exchange(false);
  return std::exchange(tFailed, false) || anywhere;
}

long liveAllocations() { return sLive; }

}  // namespace rc::test

using rc::test::allocate;
using rc::test::allocateOrNull;
using rc::test::release;
using std::align_val_t;
using std::nothrow_t;
using std::size_t;

void *operator new(size_t size) { return allocate(size); }
void *operator new[](size_t size) { return allocate(size); }
void *operator new(size_t size, align_val_t alignment) { return allocate(size, size_t(alignment)); }
void *operator new[](size_t size, align_val_t alignment) { return allocate(size, size_t(alignment)); }
void operator delete(void *memory) noexcept { release(memory); }
void operator delete[](void *memory) noexcept { release(memory); }
void operator delete(void *memory, size_t) noexcept { release(memory); }
void operator delete[](void *memory, size_t) noexcept { release(memory); }
void operator delete(void *memory, align_val_t) noexcept { release(memory); }
void operator delete[](void *memory, align_val_t) noexcept { release(memory); }
void operator delete(void *memory, size_t, align_val_t) noexcept { release(memory); }
void operator delete[](void *memory, size_t, align_val_t) noexcept { release(memory); }

// The library's own forms that do not throw would not fit the deletes above.
void *operator new(size_t size, const nothrow_t &) noexcept { return allocateOrNull(size); }
void *operator new[](size_t size, const nothrow_t &) noexcept { return allocateOrNull(size); }
void *operator new(size_t size, align_val_t alignment, const nothrow_t &) noexcept {
  return allocateOrNull(size, size_t(alignment));
}
void *operator new[](size_t size, align_val_t alignment, const nothrow_t &) noexcept {
  return allocateOrNull(size, size_t(alignment));
}
