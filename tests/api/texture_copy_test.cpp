// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcCopyTexImage2D and rcCopyTexSubImage2D: pictures become textures. [OpenGL ES 1.1, 3.7.2]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class TextureCopyTest : public ContextTest {
 protected:
  static constexpr Colour kGreen{0, 255, 0}, kClear{0, 0, 128};

  // Green from x = 20.5 on, before a blue background.
  void drawHalf() {
    pixelCamera();
    rcClearColor(0, 0, 0.5f, 0);
    paint(0, 1, 0);
    drawQuad({20.5f, -10, 80, 60});
  }
  uint32_t texel(int x, int y) const {
    const ddk::Image &image = *context->state.texture.bound[ddk::kColourMap].texture->image;
    return image.levels.at(0).at(size_t(y) * size_t(image.width) + size_t(x));
  }
};

TEST_F(TextureCopyTest, CopiesTheFrameThatWaits) {
  drawHalf();
  rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 16, 5, 16, 32, 0);
  EXPECT_CLEAN();
  for (int x = 0; x < 16; ++x) EXPECT_EQ(texel(x, 31), x > 4 ? 0xff00ff00u : 0xff800000u) << x;
  rcTextureAlpha(9);
  rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 5, 16, 16, 0);
  EXPECT_EQ(texel(15, 0), 0x0900ff00u) << "alpha as of rcTextureAlpha";
  EXPECT_CLEAN();
}

TEST_F(TextureCopyTest, RowsRunFromTheBottom) {
  pixelCamera();
  paint(0, 1, 0);
  drawQuad({-10, 20.5f, 80, 60});
  rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 0, 16, 16, 16, 0);
  for (int y = 0; y < 16; ++y) EXPECT_EQ(texel(3, y), y > 4 ? 0xff00ff00u : 0xff000000u) << y;
}

TEST_F(TextureCopyTest, BesideThePictureItIsTransparentBlack) {
  drawHalf();
  rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 56, -8, 16, 16, 0);
  EXPECT_EQ(texel(0, 8), 0xff00ff00u);
  EXPECT_EQ(texel(7, 15), 0xff00ff00u);
  for (const auto &[x, y] : {std::pair{8, 8}, {0, 7}, {15, 0}}) EXPECT_EQ(texel(x, y), 0u) << x << ' ' << y;
}

TEST_F(TextureCopyTest, APartIsReplaced) {
  drawHalf();
  loadSolid({9, 9, 9});
  rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 4, 6, 19, 10, 3, 2);
  EXPECT_CLEAN();
  EXPECT_EQ(texel(4, 6), 0x10800000u);
  EXPECT_EQ(texel(5, 6), 0x10800000u);
  EXPECT_EQ(texel(6, 7), 0x1000ff00u);
  for (const auto &[x, y] : {std::pair{3, 6}, {7, 6}, {4, 5}, {4, 8}}) EXPECT_EQ(texel(x, y), 0x10090909u) << x;
  rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 0, 0, 0, 0);
  EXPECT_CLEAN();
}

TEST_F(TextureCopyTest, ATextureShowsThePicture) {
  drawHalf();
  rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 12, 0, 16, 16, 0);
  context->endFrame();
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  drawTexturedQuad({0, 0, 64, 48});  // green from 9 / 16 of the width on
  trace();
  EXPECT_EQ(pixel(30, 20), kClear);
  EXPECT_EQ(pixel(42, 20), kGreen);
}

TEST_F(TextureCopyTest, ImageErrors) {
  loadSolid({1, 2, 3});
  EXPECT_RAISES(RC_INVALID_ENUM, rcCopyTexImage2D(kNoToken, 0, RC_RGB, 0, 0, 16, 16, 0));
  EXPECT_RAISES(RC_INVALID_ENUM, rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_ALPHA, 0, 0, 16, 16, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexImage2D(RC_TEXTURE_2D, 1, RC_RGB, 0, 0, 16, 16, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 0, 0, 16, 16, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 0, 0, 17, 16, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 0, 0, 16, -16, 0));
  context->attach(nullptr);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcCopyTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 0, 0, 16, 16, 0));
}

TEST_F(TextureCopyTest, PartErrors) {
  EXPECT_RAISES(RC_INVALID_OPERATION, rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1));  // no image
  loadSolid({1, 2, 3});
  EXPECT_RAISES(RC_INVALID_ENUM, rcCopyTexSubImage2D(kNoToken, 0, 0, 0, 0, 0, 1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexSubImage2D(RC_TEXTURE_2D, 2, 0, 0, 0, 0, 1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 16, 0, 0, 0, 1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 0, 0, 1, -1));
  context->attach(nullptr);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcCopyTexSubImage2D(RC_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1));
}

}  // namespace
}  // namespace rc::test
