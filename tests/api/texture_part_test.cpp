// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcTexSubImage2D, and how images lie in memory. [OpenGL ES 1.1, 3.6.1, 3.7.2]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class TexturePartTest : public ContextTest {
 protected:
  static constexpr RCenum kByte = RC_UNSIGNED_BYTE;

  const ddk::Image &image() const { return *context->state.texture.bound[ddk::kColourMap].texture->image; }
  uint32_t texel(int x, int y, size_t level = 0) const {
    return image().levels.at(level).at(size_t(y) * size_t(image().width >> level) + size_t(x));
  }
  void loadGrey() { loadSolid({100, 100, 100}); }
};

TEST_F(TexturePartTest, OnlyThePartIsReplaced) {
  loadGrey();
  const RCubyte part[] = {1, 2, 3, 4, 5, 6, 11, 12, 13, 14, 15, 16, 21, 22, 23, 24, 25, 26};
  rcTextureAlpha(7);
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 3, 13, 2, 3, RC_RGB, kByte, part);
  EXPECT_CLEAN();
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      uint32_t expected = 0x10646464;
      if (x >= 3 && x < 5 && y >= 13) {
        const RCubyte *given = part + 6 * (y - 13) + 3 * (x - 3);
        expected = 0x07000000u | uint32_t(given[0]) | uint32_t(given[1]) << 8 | uint32_t(given[2]) << 16;
      }
      ASSERT_EQ(texel(x, y), expected) << x << ' ' << y;
    }
  }
}

TEST_F(TexturePartTest, MipLevelsFollow) {
  loadGrey();
  const std::vector<RCubyte> white(4 * 4 * 3, 228);
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 4, 8, 4, 4, RC_RGB, kByte, white.data());
  ASSERT_EQ(image().levels.size(), 5u);
  EXPECT_EQ(texel(2, 4, 1) & 255, 228u);
  EXPECT_EQ(texel(3, 5, 1) & 255, 228u);
  EXPECT_EQ(texel(4, 4, 1) & 255, 100u);
  EXPECT_EQ(texel(0, 1, 3) & 255, 132u) << "a quarter of 8 x 8 texels";
  EXPECT_EQ(texel(0, 0, 4) & 255, 108u);
  rcTexParameteri(RC_TEXTURE_2D, RC_GENERATE_MIPMAP, RC_FALSE);
  loadGrey();
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 4, 8, 4, 4, RC_RGB, kByte, white.data());
  EXPECT_EQ(image().levels.size(), 1u) << "there were none";
}

TEST_F(TexturePartTest, ThePictureShowsIt) {
  pixelCamera();
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadGrey();
  rcStaticSceneBegin();
  drawTexturedQuad({0, 0, 32, 32});
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_EQ(pixel(5, 20), (Colour{100, 100, 100}));
  const std::vector<RCubyte> part(8 * 8 * 3, 50);
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 8, 8, 8, RC_RGB, kByte, part.data());
  rcFinish();
  EXPECT_EQ(pixel(5, 24), (Colour{50, 50, 50}));
  EXPECT_EQ(pixel(5, 5), (Colour{100, 100, 100}));
  EXPECT_EQ(pixel(25, 24), (Colour{100, 100, 100}));
}

TEST_F(TexturePartTest, RowsBeginAtTheUnpackAlignment) {
  loadGrey();
  for (const auto &[alignment, rowBytes] : {std::pair{1, 9}, {2, 10}, {4, 12}, {8, 16}}) {
    std::vector<RCubyte> bytes(48, 255);
    for (int y = 0; y < 2; ++y) {
      for (int i = 0; i < 9; ++i) bytes[size_t(y) * size_t(rowBytes) + size_t(i)] = RCubyte(10 * y + i);
    }
    rcPixelStorei(RC_UNPACK_ALIGNMENT, alignment);
    rcTexSubImage2D(RC_TEXTURE_2D, 0, 5, 5, 3, 2, RC_RGB, kByte, bytes.data());
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 3; ++x) EXPECT_EQ(texel(5 + x, 5 + y) & 255, uint32_t(10 * y + 3 * x)) << alignment;
    }
  }
  rcPixelStorei(RC_UNPACK_ALIGNMENT, 4);
  const std::vector<RCubyte> rows{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7, 8, 8, 8};
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 5, 5, 4, 2, RC_RGB, kByte, rows.data());
  EXPECT_EQ(texel(5, 6) & 255, 5u) << "12 bytes need no filling";
  rcPixelStorei(RC_UNPACK_ALIGNMENT, 8);
  // Whole images too; rows of 16 texels of two bytes need no filling.
  const std::vector<RCushort> packed(256, 31);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_SHORT_5_6_5, packed.data());
  EXPECT_EQ(texel(15, 15) & 0xffffff, 0xff0000u);
  EXPECT_CLEAN();
}

TEST_F(TexturePartTest, TypesMayDiffer) {
  loadRgba(1, 2, 3, 4);
  const RCushort packed[] = {0xF08F};
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 15, 15, 1, 1, RC_RGBA, RC_UNSIGNED_SHORT_4_4_4_4, packed);
  EXPECT_EQ(texel(15, 15), 0xff8800ffu);
  EXPECT_EQ(texel(14, 15), 0x04030201u);
  EXPECT_CLEAN();
}

TEST_F(TexturePartTest, NothingMayBeReplaced) {
  loadGrey();
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 16, 16, 0, 0, RC_RGB, kByte, "");
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 4, 4, RC_RGB, kByte, nullptr);
  EXPECT_CLEAN();
  EXPECT_EQ(texel(0, 0), 0x10646464u);
}

TEST_F(TexturePartTest, Errors) {
  const RCubyte bytes[16 * 16 * 4] = {};
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_RGB, kByte, bytes));  // no image
  loadGrey();
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexSubImage2D(kNoToken, 0, 0, 0, 1, 1, RC_RGB, kByte, bytes));
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_LUMINANCE, kByte, bytes));
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_RGB, RC_FLOAT, bytes));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexSubImage2D(RC_TEXTURE_2D, 1, 0, 0, 1, 1, RC_RGB, kByte, bytes));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexSubImage2D(RC_TEXTURE_2D, -1, 0, 0, 1, 1, RC_RGB, kByte, bytes));
  constexpr int kMost = std::numeric_limits<int>::max();
  const struct {
    int x, y, width, height;
  } outside[] = {{-1, 0, 2, 2}, {0, -1, 2, 2}, {15, 0, 2, 2}, {0, 15, 2, 2},        {0, 0, 17, 1},
                 {0, 0, 1, 17}, {0, 0, -1, 1}, {0, 0, 1, -1}, {kMost, 0, kMost, 1}, {0, kMost, 1, kMost}};
  for (const auto &[x, y, width, height] : outside) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexSubImage2D(RC_TEXTURE_2D, 0, x, y, width, height, RC_RGB, kByte, bytes));
  }
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_RGBA, kByte, bytes));
  loadRgba(1, 2, 3, 4);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_RGB, kByte, bytes));
}

}  // namespace
}  // namespace rc::test
