// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The order of a tile's pixels: each once, blocks whole, blocks that follow each other touch.
#include "rchal/tile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

namespace rc::test {
namespace {

using hal::TilePixels;

struct Size {
  int columns, rows;
};

class TileTest : public testing::TestWithParam<Size> {
 protected:
  void SetUp() override { pixels.arrange(GetParam().columns, GetParam().rows); }

  std::pair<int, int> blockOf(size_t i) const {
    return {pixels.column[i] / TilePixels::kBlock, pixels.row[i] / TilePixels::kBlock};
  }

  TilePixels pixels;
};

TEST_P(TileTest, HasEachPixelOnce) {
  std::set<std::pair<int, int>> seen;
  for (size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_LT(pixels.column[i], GetParam().columns);
    EXPECT_LT(pixels.row[i], GetParam().rows);
    EXPECT_TRUE(seen.insert({pixels.column[i], pixels.row[i]}).second) << "pixel " << i;
  }
  EXPECT_EQ(seen.size(), size_t(GetParam().columns) * size_t(GetParam().rows));
}

TEST_P(TileTest, FindsThePlaceOfEachPixel) {
  for (size_t i = 0; i < pixels.size(); ++i) EXPECT_EQ(pixels.placeOf(pixels.column[i], pixels.row[i]), i);
}

TEST_P(TileTest, GoesFromBlockToBlockBesideIt) {
  std::set<std::pair<int, int>> done;
  for (size_t i = 1; i < pixels.size(); ++i) {
    const auto before = blockOf(i - 1), here = blockOf(i);
    if (before == here) continue;
    EXPECT_EQ(std::abs(before.first - here.first) + std::abs(before.second - here.second), 1) << "pixel " << i;
    EXPECT_TRUE(done.insert(before).second) << "left twice, before pixel " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TileTest,
                         testing::Values(Size{16, 16}, Size{13, 16}, Size{16, 6}, Size{7, 11}, Size{1, 1},
                                         Size{3, 16}));

}  // namespace
}  // namespace rc::test
