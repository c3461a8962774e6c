// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rc {
namespace {

constexpr size_t kCacheLine = 64, kLargePage = size_t(2) << 20;

size_t unitOf(size_t bytes) { return bytes < kLargePage ? kCacheLine : kLargePage; }
size_t rounded(size_t bytes) { return (bytes + unitOf(bytes) - 1) / unitOf(bytes) * unitOf(bytes); }

}  // namespace

void *allocateLarge(size_t bytes) {
  void *memory = allocateCounted(rounded(bytes), unitOf(bytes));
#if defined(__linux__)
  // A wish: without it everything works, slower.
  if (unitOf(bytes) == kLargePage) madvise(memory, rounded(bytes), MADV_HUGEPAGE);
#endif
  return memory;
}

void freeLarge(void *memory, size_t bytes) noexcept { freeCounted(memory, rounded(bytes), unitOf(bytes)); }

}  // namespace rc
