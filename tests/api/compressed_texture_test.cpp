// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Paletted images: all ten formats, encoded here anew. [OpenGL ES 1.1, 3.7.4; OES_compressed_paletted_texture]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Bytes = std::vector<RCubyte>;

// A colour of the palette by its channels' bits.
struct Format {
  RCenum token;
  int entries;
  std::array<int, 4> bits;  // red, green, blue, alpha; 8 bits are bytes of their own, others are packed from the top
};
constexpr Format kFormats[] = {
    {RC_PALETTE4_RGB8_OES, 16, {8, 8, 8, 0}},     {RC_PALETTE4_RGBA8_OES, 16, {8, 8, 8, 8}},
    {RC_PALETTE4_R5_G6_B5_OES, 16, {5, 6, 5, 0}}, {RC_PALETTE4_RGBA4_OES, 16, {4, 4, 4, 4}},
    {RC_PALETTE4_RGB5_A1_OES, 16, {5, 5, 5, 1}},  {RC_PALETTE8_RGB8_OES, 256, {8, 8, 8, 0}},
    {RC_PALETTE8_RGBA8_OES, 256, {8, 8, 8, 8}},   {RC_PALETTE8_R5_G6_B5_OES, 256, {5, 6, 5, 0}},
    {RC_PALETTE8_RGBA4_OES, 256, {4, 4, 4, 4}},   {RC_PALETTE8_RGB5_A1_OES, 256, {5, 5, 5, 1}}};

constexpr RCubyte kTextureAlpha = 77;

// The value of a channel of an entry, in its bits.
int channel(const Format &format, int entry, size_t i) {
  return (entry * 37 + int(i) * 91 + 5) & ((1 << format.bits[i]) - 1);
}

int indexAt(const Format &format, int x, int y) { return (x * 7 + y * 13) % format.entries; }

// Palette and the given number of levels.
Bytes encode(const Format &format, int width, int height, int levels) {
  Bytes bytes;
  for (int entry = 0; entry < format.entries; ++entry) {
    int packed = 0;
    for (size_t i = 0; i < 4; ++i) {
      if (format.bits[i] == 8) bytes.push_back(RCubyte(channel(format, entry, i)));
      packed = packed << format.bits[i] | channel(format, entry, i);
    }
    if (format.bits[0] == 8) continue;
    const auto word = static_cast<RCushort>(packed);
    bytes.push_back(RCubyte(word & 255));  // little-endian, as this machine
    bytes.push_back(RCubyte(word >> 8));
  }
  for (int level = 0; level < levels; ++level) {
    const int w = std::max(width >> level, 1), h = std::max(height >> level, 1);
    int half = -1;  // the upper half of a byte
    for (int i = 0; i < w * h; ++i) {
      const int index = level == 0 ? indexAt(format, i % w, i / w) : 0;
      if (format.entries == 256) {
        bytes.push_back(RCubyte(index));
      } else if (half < 0) {
        half = index;
      } else {
        bytes.push_back(RCubyte(half << 4 | index));
        half = -1;
      }
    }
    if (half >= 0) bytes.push_back(RCubyte(half << 4));
  }
  return bytes;
}

// What a texel is: full stays full.
double expected(const Format &format, int entry, size_t i) {
  if (format.bits[i] == 0) return kTextureAlpha;
  return channel(format, entry, i) * 255.0 / ((1 << format.bits[i]) - 1);
}

class CompressedTextureTest : public ContextTest {
 protected:
  void load(const Format &format, int width, int height, int level, const Bytes &bytes) {
    rcCompressedTexImage2D(RC_TEXTURE_2D, level, format.token, width, height, 0, RCsizei(bytes.size()), bytes.data());
  }
  const ddk::Texture &texture() const { return *context->state.texture.bound[ddk::kColourMap].texture; }
};

TEST_F(CompressedTextureTest, TheFormatsAreNamed) {
  EXPECT_EQ(integer(RC_NUM_COMPRESSED_TEXTURE_FORMATS), 10);
  RCint names[16] = {};
  rcGetIntegerv(RC_COMPRESSED_TEXTURE_FORMATS, names);
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ(RCenum(names[i]), kFormats[i].token);
}

TEST_F(CompressedTextureTest, EveryTexelOfEveryFormat) {
  rcTextureAlpha(kTextureAlpha);
  for (const Format &format : kFormats) {
    load(format, 32, 16, 0, encode(format, 32, 16, 1));
    ASSERT_EQ(rcGetError(), RCenum(RC_NO_ERROR)) << format.token;
    ASSERT_EQ(texture().image->width, 32);
    ASSERT_EQ(texture().image->height, 16);
    ASSERT_EQ(texture().image->levels.size(), 6u);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 32; ++x) {
        const uint32_t texel = texture().image->levels[0][size_t(y) * 32 + size_t(x)];
        for (size_t i = 0; i < 4; ++i) {
          ASSERT_NEAR(texel >> 8 * i & 255, expected(format, indexAt(format, x, y), i), 1)
              << format.token << " at " << x << ' ' << y << " channel " << i;
        }
      }
    }
  }
}

TEST_F(CompressedTextureTest, FurtherLevelsAreMadeAnew) {
  for (const Format &format : kFormats) {
    for (int further : {0, 1, 4}) {
      load(format, 16, 16, -further, encode(format, 16, 16, 1 + further));
      EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR)) << format.token << ' ' << further;
      double mean = 0;
      for (uint32_t texel : texture().image->levels[0]) mean += double(texel & 255) / 256;
      EXPECT_NEAR(texture().image->levels.at(4).at(0) & 255, mean, 3) << "not what came along";
    }
  }
}

TEST_F(CompressedTextureTest, AreShownAndCanBeChangedInPart) {
  pixelCamera();
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  Bytes bytes(16 * 3 + 128, 0x33);
  bytes[9] = 200, bytes[10] = 100, bytes[11] = 50;  // entry 3
  load(kFormats[0], 16, 16, 0, bytes);
  drawTexturedQuad({0, 0, 64, 48});
  trace();
  EXPECT_EQ(pixel(30, 20), (Colour{200, 100, 50}));
  const RCubyte one[] = {1, 2, 3, 4};
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 1, 1, RC_RGB, RC_UNSIGNED_BYTE, one);
  EXPECT_CLEAN();
  EXPECT_EQ(texture().image->levels[0][0] & 0xffffff, 0x030201u);
}

TEST_F(CompressedTextureTest, NullDataLoadsNothing) {
  loadSolid({1, 2, 3});
  rcCompressedTexImage2D(RC_TEXTURE_2D, 0, RC_PALETTE8_RGBA8_OES, 16, 16, 0, 256 * 4 + 256, nullptr);
  EXPECT_CLEAN();
  EXPECT_EQ(texture().image->levels[0][0] & 0xffffff, 0x030201u);
}

TEST_F(CompressedTextureTest, Errors) {
  loadSolid({1, 2, 3});
  const Bytes data(4096);
  constexpr RCenum kFormat = RC_PALETTE8_RGB8_OES;
  constexpr RCsizei kSize = 256 * 3 + 256;
  EXPECT_RAISES(RC_INVALID_ENUM, rcCompressedTexImage2D(kNoToken, 0, kFormat, 16, 16, 0, kSize, data.data()));
  for (RCenum format :
       {RCenum(RC_RGB), kNoToken, RCenum(RC_PALETTE4_RGB8_OES - 1), RCenum(RC_PALETTE8_RGB5_A1_OES + 1)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcCompressedTexImage2D(RC_TEXTURE_2D, 0, format, 16, 16, 0, kSize, data.data()));
  }
  const auto fails = [&](int level, int width, int height, int border, int size) {
    EXPECT_RAISES(RC_INVALID_VALUE,
                  rcCompressedTexImage2D(RC_TEXTURE_2D, level, kFormat, width, height, border, size, data.data()));
  };
  fails(1, 16, 16, 0, kSize);
  fails(-15, 16, 16, 0, kSize);
  fails(std::numeric_limits<int>::min(), 16, 16, 0, kSize);
  fails(0, 16, 16, 1, kSize);
  for (int side : {-16, 0, 8, 17, 2048}) {
    fails(0, side, 16, 0, kSize);
    fails(0, 16, side, 0, kSize);
  }
  for (int size : {kSize - 1, kSize + 1, 0, -kSize}) fails(0, 16, 16, 0, size);
  fails(-1, 16, 16, 0, kSize);  // the next level is missing
}

TEST_F(CompressedTextureTest, NoneCanBeReplacedInPart) {
  load(kFormats[5], 16, 16, 0, encode(kFormats[5], 16, 16, 1));
  EXPECT_CLEAN();
  const Bytes data(2048);
  for (const Format &format : kFormats) {
    EXPECT_RAISES(RC_INVALID_OPERATION,
                  rcCompressedTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 16, 16, format.token, 1024, data.data()));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcCompressedTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 16, 16, RC_RGB, 1024, data.data()));
  EXPECT_RAISES(RC_INVALID_ENUM,
                rcCompressedTexSubImage2D(kNoToken, 0, 0, 0, 16, 16, RC_PALETTE8_RGB8_OES, 1024, data.data()));
}

}  // namespace
}  // namespace rc::test
