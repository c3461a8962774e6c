// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// large_pages.h: memory for arrays of megabytes that are read here and there: on whole cache lines, and on pages of
// two megabytes where the system lends them, so that fewer addresses have to be translated.
#pragma once

#include "base/memory.h"

namespace rc {

// 64-byte aligned. Throws std::bad_alloc. Freed with the same number.
void *allocateLarge(size_t bytes);
void freeLarge(void *memory, size_t bytes) noexcept;

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U> &) noexcept {}

  T *allocate(size_t count) {
    if (count > PTRDIFF_MAX / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T *>(allocateLarge(count * sizeof(T)));
  }
  void deallocate(T *memory, size_t count) noexcept { freeLarge(memory, count * sizeof(T)); }
  friend bool operator==(const LargePages &, const LargePages &) { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace rc
