// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// large_pages.h: memory for arrays of megabytes that are read here and there: on whole cache lines, and on pages of
// two megabytes where the system lends them, so that fewer addresses have to be translated.
#pragma once

#include <cstddef>
#include <vector>

namespace rc {

// 64-byte aligned. Throws std::bad_alloc.
void *allocateLarge(size_t bytes);
void freeLarge(void *memory) noexcept;

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U> &) noexcept {}

  T *allocate(size_t count) { return static_cast<T *>(allocateLarge(count * sizeof(T))); }
  void deallocate(T *memory, size_t) noexcept { freeLarge(memory); }
  friend bool operator==(const LargePages &, const LargePages &) { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace rc
