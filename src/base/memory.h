// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// memory.h: the one door for memory whose size a program decides: triangles, structures, texels, pictures, buffers,
// queues of rays, and what builders need meanwhile. What goes through it is counted, and refused with std::bad_alloc
// where it would be more than RAYCORE_MEMORY_LIMIT allows: before the machine swaps, or ends the process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace rc {

// Thrown beyond the limit.
struct MemoryRefused : std::bad_alloc {
  const char *what() const noexcept override;
};

// Smaller pieces are not counted: there are many, and threads would wait for one another at the count.
inline constexpr size_t kLeastCounted = 1024;

// The memory is aligned to `alignment`, a power of two. Freed with the same numbers.
void *allocateCounted(size_t bytes, size_t alignment);
void freeCounted(void *memory, size_t bytes, size_t alignment) noexcept;

// Bytes that are counted now, in the whole process; the most that may be.
size_t countedMemory();
uint64_t memoryLimit();

// The limit from now on; for tests.
void setMemoryLimit(uint64_t bytes);

// For vectors of them.
template <class T>
struct Counted {
  using value_type = T;

  Counted() = default;
  template <class U>
  Counted(const Counted<U> &) noexcept {}

  T *allocate(size_t count) {
    if (count > PTRDIFF_MAX / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T *>(allocateCounted(count * sizeof(T), alignof(T)));
  }
  void deallocate(T *memory, size_t count) noexcept { freeCounted(memory, count * sizeof(T), alignof(T)); }
  friend bool operator==(const Counted &, const Counted &) { return true; }
};

template <class T>
using Array = std::vector<T, Counted<T>>;

}  // namespace rc
