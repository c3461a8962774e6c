// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// column_block.h: what queues are made of: columns of the same length in one block of memory, with one size, so that a
// queue grows, is emptied and changes hands at once, however many columns it has.
#pragma once

#include "rchal/column.h"

namespace rc::hal {

// Values of four bytes each; see Column about the room behind their end.
template <class T>
class BlockColumn {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) == 4);

 public:
  T *data() { return mValues; }
  const T *data() const { return mValues; }
  T &operator[](size_t i) { return mValues[i]; }
  const T &operator[](size_t i) const { return mValues[i]; }

 private:
  template <class Columns>
  friend class ColumnBlock;

  T *mValues = nullptr;
};

// Columns: the class that derives from it; its forEachColumn(visit, blocks...) calls visit(column of each block...).
template <class Columns>
class ColumnBlock {
 public:
  size_t size() const { return mSize; }
  void reserve(size_t count) {
    if (count > mCapacity) moveTo(std::max(count, 2 * mCapacity));
  }
  // What is added has any value.
  void resize(size_t size) {
    reserve(size);
    mSize = size;
  }
  // As many more, which were written behind the end: there is room. Vector code that may have to call something keeps
  // its vectors in memory.
  void extend(size_t count) { mSize += count; }
  // Returns the place of a new item, which has any value.
  size_t add() {
    resize(mSize + 1);
    return mSize - 1;
  }
  // Moves the last `count` items to `taken`, in their order; what that held is dropped.
  void takeLast(size_t count, Columns &taken) {
    const size_t first = mSize - count;
    if (first == 0) {
      std::swap(self(), taken);
    } else {
      taken.resize(count);
      Columns::forEachColumn([&](auto &from, auto &to) { std::copy_n(from.data() + first, count, to.data()); }, self(),
                             taken);
    }
    mSize = first;
  }

 protected:
  ColumnBlock() = default;
  ~ColumnBlock() = default;
  ColumnBlock(ColumnBlock &&other) noexcept { *this = std::move(other); }
  ColumnBlock &operator=(ColumnBlock &&other) noexcept {
    mBlock = std::move(other.mBlock);
    mSize = std::exchange(other.mSize, 0);
    mCapacity = std::exchange(other.mCapacity, 0);  // its columns point to nothing of its own
    return *this;
  }

 private:
  Columns &self() { return static_cast<Columns &>(*this); }

  void moveTo(size_t capacity) {
    constexpr size_t kValue = 4, kLine = 64 / kValue;  // bytes; values of a cache line
    const size_t stride = (capacity + kLine - 1) / kLine * kLine + Column<float>::kSlack;
    size_t columns = 0;
    Columns::forEachColumn([&](auto &) { ++columns; }, self());
    LargeVector<std::byte> block(columns * stride * kValue);
    std::byte *values = block.data();
    Columns::forEachColumn(
        [&]<class T>(BlockColumn<T> &column) {
          auto *const moved = reinterpret_cast<T *>(values);
          std::copy_n(column.data(), mSize, moved);
          column.mValues = moved;
          values += stride * kValue;
        },
        self());
    mBlock = std::move(block);
    mCapacity = capacity;
  }

  // Zeros at first: what lies behind the end may be computed with, and denormal numbers would be slow.
  LargeVector<std::byte> mBlock;
  size_t mSize = 0, mCapacity = 0;
};

}  // namespace rc::hal
