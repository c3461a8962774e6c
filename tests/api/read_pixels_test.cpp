// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcReadPixels and rcPixelStorei. [OpenGL ES 1.1, 4.3, 3.6.1]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class ReadPixelsTest : public ContextTest {
 protected:
  static constexpr RCubyte kMark = 0xAB;

  // White from x = 20.5 and y = 10.5 on.
  void drawCorner() {
    pixelCamera();
    paint(1, 1, 1);
    drawQuad({20.5f, 10.5f, 80, 60});
  }
  std::vector<RCubyte> read(int x, int y, int width, int height, RCenum format) {
    std::vector<RCubyte> bytes(256, kMark);
    rcReadPixels(x, y, width, height, format, RC_UNSIGNED_BYTE, bytes.data());
    EXPECT_CLEAN();
    return bytes;
  }
};

TEST_F(ReadPixelsTest, Alignments) {
  EXPECT_EQ(integer(RC_PACK_ALIGNMENT), 4);
  EXPECT_EQ(integer(RC_UNPACK_ALIGNMENT), 1) << "unlike in GL";
  for (RCint value : {1, 2, 4, 8}) {
    rcPixelStorei(RC_PACK_ALIGNMENT, value);
    rcPixelStorei(RC_UNPACK_ALIGNMENT, 9 - value > 4 ? 8 : 2);
    EXPECT_EQ(integer(RC_PACK_ALIGNMENT), value);
    EXPECT_EQ(integer(RC_UNPACK_ALIGNMENT), 9 - value > 4 ? 8 : 2);
    EXPECT_EQ(floats(RC_PACK_ALIGNMENT, 1)[0], float(value));
  }
  EXPECT_CLEAN();
  for (RCint value : {0, 3, 16, -1}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcPixelStorei(RC_PACK_ALIGNMENT, value));
    EXPECT_RAISES(RC_INVALID_VALUE, rcPixelStorei(RC_UNPACK_ALIGNMENT, value));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcPixelStorei(kNoToken, 4));
}

TEST_F(ReadPixelsTest, TheLowestRowComesFirst) {
  drawCorner();
  const std::vector<RCubyte> bytes = read(20, 10, 2, 2, RC_RGBA);  // the frame that waits is traced first
  const RCubyte expected[] = {0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255};
  for (size_t i = 0; i < 16; ++i) EXPECT_EQ(bytes[i], expected[i]) << i;
  EXPECT_EQ(bytes[16], kMark);
}

TEST_F(ReadPixelsTest, ChannelsAreInOrder) {
  rcClearColor(1, 0.5f, 0.25f, 0);
  const std::vector<RCubyte> rgba = read(3, 4, 1, 1, RC_RGBA), rgb = read(3, 4, 1, 1, RC_RGB);
  for (const auto &bytes : {rgba, rgb}) {
    EXPECT_EQ(bytes[0], 255);
    EXPECT_EQ(bytes[1], 128);
    EXPECT_EQ(bytes[2], 64);
  }
  EXPECT_EQ(rgba[3], 255);
  EXPECT_EQ(rgb[3], kMark);
}

TEST_F(ReadPixelsTest, RowsBeginAtTheAlignment) {
  drawCorner();
  const struct {
    RCint alignment;
    size_t rowBytes;  // of three pixels of three bytes
  } cases[] = {{1, 9}, {2, 10}, {4, 12}, {8, 16}};
  for (const auto &[alignment, rowBytes] : cases) {
    rcPixelStorei(RC_PACK_ALIGNMENT, alignment);
    const std::vector<RCubyte> bytes = read(19, 10, 3, 2, RC_RGB);
    for (size_t i = 0; i < rowBytes; ++i) EXPECT_EQ(bytes[i], i < 9 ? 0 : kMark) << alignment << ' ' << i;
    for (size_t i = 0; i < 9; ++i) EXPECT_EQ(bytes[rowBytes + i], i < 6 ? 0 : 255) << alignment << ' ' << i;
    EXPECT_EQ(bytes[rowBytes + 9], kMark);
  }
}

TEST_F(ReadPixelsTest, RowsThatEndAtTheAlignmentAreNotFilled) {
  drawCorner();
  for (const auto &[alignment, rowBytes] : {std::pair{1, 12u}, {2, 12u}, {4, 12u}, {8, 16u}}) {
    rcPixelStorei(RC_PACK_ALIGNMENT, alignment);
    const std::vector<RCubyte> bytes = read(21, 10, 4, 2, RC_RGB);
    EXPECT_EQ(bytes[rowBytes - 1], rowBytes == 12 ? 0 : kMark) << alignment;
    EXPECT_EQ(bytes[rowBytes], 255) << alignment;
    EXPECT_EQ(bytes[rowBytes + 12], kMark) << alignment;
  }
}

TEST_F(ReadPixelsTest, WhatLiesBesideThePictureIsLeftAlone) {
  rcClearColor(1, 1, 1, 1);
  const std::vector<RCubyte> low = read(-2, -1, 3, 2, RC_RGBA), high = read(63, 47, 2, 2, RC_RGBA);
  for (size_t i = 0; i < 24; ++i) EXPECT_EQ(low[i], i / 4 == 5 ? 255 : kMark) << i;
  for (size_t i = 0; i < 16; ++i) EXPECT_EQ(high[i], i / 4 == 0 ? 255 : kMark) << i;
  for (RCubyte byte : read(std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 3, 3, RC_RGBA)) {
    ASSERT_EQ(byte, kMark);
  }
}

TEST_F(ReadPixelsTest, OnlyAChangedPictureIsTracedAnew) {
  drawCorner();
  rcFinish();
  surface.fill(0x04030201);
  EXPECT_EQ(read(0, 0, 1, 1, RC_RGBA)[0], 1) << "what is in the picture";
  rcClearColor(1, 1, 1, 1);
  EXPECT_EQ(read(0, 0, 1, 1, RC_RGBA)[0], 255);
}

TEST_F(ReadPixelsTest, NothingMayBeAskedFor) {
  rcReadPixels(0, 0, 4, 4, RC_RGBA, RC_UNSIGNED_BYTE, nullptr);
  EXPECT_CLEAN();
  EXPECT_EQ(read(0, 0, 0, 0, RC_RGBA)[0], kMark);
  EXPECT_EQ(read(0, 0, 0, 5, RC_RGBA)[0], kMark);
}

TEST_F(ReadPixelsTest, TheOfferedFormatCanBeRead) {
  RCubyte bytes[4] = {};
  rcReadPixels(0, 0, 1, 1, RCenum(integer(RC_IMPLEMENTATION_COLOR_READ_FORMAT_OES)),
               RCenum(integer(RC_IMPLEMENTATION_COLOR_READ_TYPE_OES)), bytes);
  EXPECT_CLEAN();
}

TEST_F(ReadPixelsTest, Errors) {
  RCubyte bytes[64] = {};
  EXPECT_RAISES(RC_INVALID_ENUM, rcReadPixels(0, 0, 1, 1, kNoToken, RC_UNSIGNED_BYTE, bytes));
  EXPECT_RAISES(RC_INVALID_ENUM, rcReadPixels(0, 0, 1, 1, RC_LUMINANCE, RC_UNSIGNED_BYTE, bytes));
  EXPECT_RAISES(RC_INVALID_ENUM, rcReadPixels(0, 0, 1, 1, RC_RGBA, kNoToken, bytes));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcReadPixels(0, 0, 1, 1, RC_RGBA, RC_FLOAT, bytes));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcReadPixels(0, 0, 1, 1, RC_RGB, RC_UNSIGNED_SHORT_5_6_5, bytes));
  EXPECT_RAISES(RC_INVALID_VALUE, rcReadPixels(0, 0, -1, 1, RC_RGBA, RC_UNSIGNED_BYTE, bytes));
  EXPECT_RAISES(RC_INVALID_VALUE, rcReadPixels(0, 0, 1, -1, RC_RGBA, RC_UNSIGNED_BYTE, bytes));
  context->attach(nullptr);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcReadPixels(0, 0, 1, 1, RC_RGBA, RC_UNSIGNED_BYTE, bytes));
  EXPECT_EQ(bytes[0], 0);
}

}  // namespace
}  // namespace rc::test
