// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/allocation_failure.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace rc::test {
namespace {

constexpr int kNever = -1;
thread_local int tGood = kNever;
thread_local bool tFailed = false;

void *allocate(std::size_t size) {
  if (tGood != kNever && tGood-- == 0) {
    tFailed = true;
    throw std::bad_alloc();
  }
  void *memory = std::malloc(size == 0 ? 1 : size);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void failAllocationAfter(int good) {
  tGood = good;
  tFailed = false;
}

bool allocationFailed() {
  tGood = kNever;
  return std::exchange(tFailed, false);
}

}  // namespace rc::test

void *operator new(std::size_t size) { return rc::test::allocate(size); }
void *operator new[](std::size_t size) { return rc::test::allocate(size); }
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete[](void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void *memory, std::size_t) noexcept { std::free(memory); }

// The library's own forms that do not throw would not fit the deletes above.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
  try {
    return rc::test::allocate(size);
  } catch (const std::bad_alloc &) {
    return nullptr;
  }
}
void *operator new[](std::size_t size, const std::nothrow_t &tag) noexcept { return operator new(size, tag); }
