// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tile.h: the pixels of a tile in the order in which rays leave them: blocks of 4 x 4, so that pixels which lie beside
// each other in both directions follow each other in the queue and their rays stay together. Rows of blocks run to and
// fro: where some rays are missing, 16 that follow each other belong to two blocks, and these touch.
#pragma once

#include "rchal/column.h"
#include "rchal/scene_view.h"

namespace rc::hal {

using Tile = PixelRect;  // of the viewport; small enough for the queues of its rays

// The part of a pixel that a ray stands for.
struct PixelSample {
  Vec2 place{0, 0};  // 0 <= x, y < 1
  float width = 1;   // of its footprint, in pixels
};

class TilePixels {
 public:
  static constexpr int kBlock = 4;  // pixels a side

  void arrange(int columns, int rows) {
    if (columns == mColumns && rows == mRows) return;
    // First, since it may be that there is no memory: then the arrangement is still the old one.
    column.reserve(size_t(columns) * size_t(rows));
    row.reserve(size_t(columns) * size_t(rows));
    mColumns = columns;
    mRows = rows;
    column.resize(0);
    row.resize(0);
    for (int y = 0; y < rows; y += kBlock) {
      for (int x = 0; x < columns; x += kBlock) addBlock(isBackwards(y) ? (columns - 1) / kBlock * kBlock - x : x, y);
    }
  }
  // Some of another tile's pixels, in its order.
  void clear() { arrange(0, 0); }
  void add(int32_t x, int32_t y) {
    column.push_back(x);
    row.push_back(y);
    mColumns = -1;
  }
  size_t size() const { return column.size(); }
  int columns() const { return mColumns; }  // below 0: they are some of a tile's
  int rows() const { return mRows; }
  bool areWholeBlocks() const { return mColumns > 0 && mColumns % kBlock == 0 && mRows % kBlock == 0; }
  // The place of a pixel in the order of a whole tile.
  size_t placeOf(int x, int y) const {
    const int left = x / kBlock * kBlock, bottom = y / kBlock * kBlock;
    const int height = std::min(kBlock, mRows - bottom), width = std::min(kBlock, mColumns - left);
    const int before = isBackwards(bottom) ? mColumns - left - width : left;
    return size_t(bottom * mColumns + before * height + (y - bottom) * width + x - left);
  }

  Column<int32_t> column, row;  // within the tile

 private:
  static bool isBackwards(int row) { return row / kBlock % 2 == 1; }
  void addBlock(int left, int bottom) {
    for (int y = bottom; y < std::min(bottom + kBlock, mRows); ++y) {
      for (int x = left; x < std::min(left + kBlock, mColumns); ++x) {
        column.push_back(x);
        row.push_back(y);
      }
    }
  }

  int mColumns = 0, mRows = 0;
};

}  // namespace rc::hal
