// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// column.h: a growing array of plain values, as vector instructions want it: aligned, not filled when it grows, and
// with room for one more vector behind its end, so that the last values can be read and written as a whole vector.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "base/large_pages.h"

namespace rc::hal {

template <class T>
class Column {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  static constexpr size_t kSlack = 16;  // values that may be read and written behind the end

  Column() = default;
  Column(Column &&other) noexcept { swap(other); }
  Column &operator=(Column &&other) noexcept {
    swap(other);
    return *this;
  }

  size_t size() const { return mSize; }
  T *data() { return mValues.data(); }
  const T *data() const { return mValues.data(); }
  T &operator[](size_t i) { return mValues[i]; }
  const T &operator[](size_t i) const { return mValues[i]; }

  void reserve(size_t count) {
    if (count <= mCapacity) return;
    const size_t capacity = std::max(count, 2 * mCapacity);
    LargeVector<T> values(capacity + kSlack);
    std::copy_n(data(), mSize, values.data());
    mValues = std::move(values);
    mCapacity = capacity;
  }
  // What is added has any value.
  void resize(size_t size) {
    reserve(size);
    mSize = size;
  }
  void assign(size_t size, T value) {
    resize(size);
    std::fill_n(data(), size, value);
  }
  void push_back(T value) {
    if (mSize == mCapacity) reserve(mSize + kSlack);
    mValues[mSize++] = value;
  }

 private:
  void swap(Column &other) noexcept {
    std::swap(mValues, other.mValues);
    std::swap(mSize, other.mSize);
    std::swap(mCapacity, other.mCapacity);
  }

  // Zeros at first: what lies behind the end may be computed with, and denormal numbers would be slow.
  LargeVector<T> mValues;
  size_t mSize = 0, mCapacity = 0;
};

}  // namespace rc::hal
