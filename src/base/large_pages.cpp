// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/large_pages.h"

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rc {
namespace {

constexpr size_t kCacheLine = 64, kLargePage = size_t(2) << 20;

}  // namespace

void *allocateLarge(size_t bytes) {
  const size_t unit = bytes < kLargePage ? kCacheLine : kLargePage;
  const size_t rounded = (bytes + unit - 1) / unit * unit;
  void *memory = rounded < bytes ? nullptr : std::aligned_alloc(unit, rounded);
  if (!memory) throw std::bad_alloc();
#if defined(__linux__)
  // A wish: without it everything works, slower.
  if (unit == kLargePage) madvise(memory, rounded, MADV_HUGEPAGE);
#endif
  return memory;
}

void freeLarge(void *memory) noexcept { std::free(memory); }

}  // namespace rc
