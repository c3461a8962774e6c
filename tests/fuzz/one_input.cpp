// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What every fuzz target begins with, and its operator new. While an input runs, what is larger than a small machine's
// memory is refused at once, as an input may ask for images and buffers of any size. Sanitizers' own operator new ends
// the process instead.
#include <atomic>
#include <cstdlib>
#include <new>

#include "input.h"

namespace {

constexpr std::size_t kLargest = std::size_t{8} << 20;
constinit std::atomic<bool> gLimited = false;

void *allocate(std::size_t size) noexcept {
  return size > kLargest && gLimited.load(std::memory_order_relaxed) ? nullptr : std::malloc(size == 0 ? 1 : size);
}

void *allocateOrThrow(std::size_t size) {
  if (void *memory = allocate(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void *operator new(std::size_t size) { return allocateOrThrow(size); }
void *operator new[](std::size_t size) { return allocateOrThrow(size); }
void *operator new(std::size_t size, const std::nothrow_t &) noexcept { return allocate(size); }
void *operator new[](std::size_t size, const std::nothrow_t &) noexcept { return allocate(size); }
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete[](void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void *memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void *memory, const std::nothrow_t &) noexcept { std::free(memory); }
void operator delete[](void *memory, const std::nothrow_t &) noexcept { std::free(memory); }

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  gLimited = true;
  rc::fuzz::run(rc::fuzz::Input(data, size));
  gLimited = false;
  return 0;
}
