// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/memory.h"

#include <atomic>

#include "base/machine_memory.h"
#include "base/settings.h"

namespace rc {
namespace {

constinit std::atomic<size_t> sCounted = 0;

std::atomic<uint64_t> &limit() {
  static std::atomic<uint64_t> bytes = settings().memoryLimit ? settings().memoryLimit : defaultMemoryLimit();
  return bytes;
}

void count(size_t bytes) {
  const uint64_t most = memoryLimit(), before = sCounted.fetch_add(bytes, std::memory_order_relaxed);
  if (bytes <= most && before <= most - bytes) return;
  sCounted.fetch_sub(bytes, std::memory_order_relaxed);
  throw MemoryRefused();
}

// Most need no more than every allocation has.
bool plain(size_t alignment) { return alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__; }

void uncount(size_t bytes) noexcept { sCounted.fetch_sub(bytes, std::memory_order_relaxed); }

}  // namespace

const char *MemoryRefused::what() const noexcept { return "more memory is asked for than RAYCORE_MEMORY_LIMIT allows"; }

size_t countedMemory() { return sCounted.load(std::memory_order_relaxed); }
uint64_t memoryLimit() { return limit().load(std::memory_order_relaxed); }
void setMemoryLimit(uint64_t bytes) { limit() = bytes; }

void *allocateCounted(size_t bytes, size_t alignment) {
  const bool counted = bytes >= kLeastCounted;
  if (counted) count(bytes);
  try {
    return plain(alignment) ? ::operator new(bytes) : ::operator new(bytes, std::align_val_t(alignment));
  } catch (...) {
    if (counted) uncount(bytes);
    throw;
  }
}

void freeCounted(void *memory, size_t bytes, size_t alignment) noexcept {
  if (plain(alignment)) {
    ::operator delete(memory);
  } else {
    ::operator delete(memory, std::align_val_t(alignment));
  }
  if (bytes >= kLeastCounted) uncount(bytes);
}

}  // namespace rc
