// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Which pixels, channels and samples of the picture are traced: scissor box, colour mask, RC_MULTISAMPLE.
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class PictureTest : public ContextTest {
 protected:
  // Whether exactly the pixels of left <= x < right, bottom <= y < top were written.
  void expectWritten(int left, int bottom, int right, int top) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool inside = x >= left && x < right && y >= bottom && y < top;
        const uint32_t pixel = surface.pixels[size_t(kHeight - 1 - y) * kWidth + size_t(x)];
        ASSERT_EQ(pixel != kUntouched, inside) << x << ' ' << y;
      }
    }
  }
  void scissor(int x, int y, int width, int height) {
    surface.fill(kUntouched);
    rcScissor(x, y, width, height);
    rcFinish();
  }
};

TEST_F(PictureTest, InitialState) {
  EXPECT_FALSE(rcIsEnabled(RC_SCISSOR_TEST));
  EXPECT_EQ(floats(RC_SCISSOR_BOX, 4), (Values{0, 0, kWidth, kHeight}));
  EXPECT_EQ(floats(RC_COLOR_WRITEMASK, 4), (Values{1, 1, 1, 1}));
  EXPECT_TRUE(rcIsEnabled(RC_MULTISAMPLE));
  EXPECT_EQ(integer(RC_SAMPLES), 0);
  EXPECT_EQ(integer(RC_SAMPLE_BUFFERS), 0);
}

TEST_F(PictureTest, IsKept) {
  rcScissor(-3, 4, 5, 6);
  EXPECT_EQ(floats(RC_SCISSOR_BOX, 4), (Values{-3, 4, 5, 6}));
  RCfixed fixed[4];
  rcGetFixedv(RC_SCISSOR_BOX, fixed);
  EXPECT_EQ(fixed[0], -3 * kFixedOne);
  rcColorMask(RC_TRUE, RC_FALSE, 7, RC_FALSE);
  EXPECT_EQ(floats(RC_COLOR_WRITEMASK, 4), (Values{1, 0, 1, 0}));
  RCboolean flags[4];
  rcGetBooleanv(RC_COLOR_WRITEMASK, flags);
  EXPECT_EQ(flags[2], RC_TRUE);
  EXPECT_EQ(flags[3], RC_FALSE);
  EXPECT_CLEAN();
}

TEST_F(PictureTest, ScissorErrors) {
  EXPECT_RAISES(RC_INVALID_VALUE, rcScissor(0, 0, -1, 5));
  EXPECT_RAISES(RC_INVALID_VALUE, rcScissor(0, 0, 5, -1));
}

TEST_F(PictureTest, OnlyTheScissorBoxIsTraced) {
  rcEnable(RC_SCISSOR_TEST);
  scissor(10, 5, 20, 10);
  expectWritten(10, 5, 30, 15);
  EXPECT_EQ(integer(RC_FRAME_RAYS), 200);
}

TEST_F(PictureTest, TheScissorBoxMayLieAnywhere) {
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  rcEnable(RC_SCISSOR_TEST);
  scissor(-5, -7, 12, 9);
  expectWritten(0, 0, 7, 2);
  scissor(60, 40, 100, 100);
  expectWritten(60, 40, kWidth, kHeight);
  for (const auto &[x, y] : {std::pair{100, 5}, {5, 48}, {-20, 5}, {5, -20}, {kLeast, 0}, {0, kLeast}, {kMost, 0}}) {
    scissor(x, y, 20, 20);
    expectWritten(0, 0, 0, 0);
    EXPECT_EQ(integer(RC_FRAME_RAYS), 0) << x << ' ' << y;
  }
  scissor(20, 20, 0, 5);
  expectWritten(0, 0, 0, 0);
  scissor(1, 2, kMost, kMost);
  expectWritten(1, 2, kWidth, kHeight);
  scissor(-1, -1, kMost, kMost);
  expectWritten(0, 0, kWidth, kHeight);
  scissor(33, 17, 1, 1);
  expectWritten(33, 17, 34, 18);
  EXPECT_CLEAN();
}

TEST_F(PictureTest, OffTheScissorBoxCutsNothing) {
  scissor(10, 5, 20, 10);
  expectWritten(0, 0, kWidth, kHeight);
}

TEST_F(PictureTest, TheViewIsNotScaledByTheScissorBox) {
  pixelCamera();
  paint(1, 1, 1);
  rcEnable(RC_SCISSOR_TEST);
  rcScissor(10, 5, 20, 10);
  drawQuad({15.5f, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(15, 10), kBlack);
  EXPECT_EQ(pixel(16, 10), (Colour{255, 255, 255}));
}

TEST_F(PictureTest, AColourMaskKeepsTheOtherChannels) {
  surface.fill(0);
  rcClearColor(1, 1, 1, 1);
  rcColorMask(RC_TRUE, RC_FALSE, RC_FALSE, RC_FALSE);
  rcFinish();
  EXPECT_EQ(surface.pixels[0], 0x000000ffu);
  rcClearColor(0.5f, 0.5f, 0.5f, 1);
  rcColorMask(RC_FALSE, RC_FALSE, RC_TRUE, RC_FALSE);
  rcFinish();
  EXPECT_EQ(surface.pixels[0], 0x008000ffu);
  rcColorMask(RC_FALSE, RC_FALSE, RC_FALSE, RC_TRUE);
  rcFinish();
  EXPECT_EQ(surface.pixels[0], 0xff8000ffu);
  rcClearColor(0, 0, 0, 0);
  rcColorMask(RC_FALSE, RC_TRUE, RC_FALSE, RC_FALSE);
  rcFinish();
  EXPECT_EQ(surface.pixels[0], 0xff8000ffu);
  rcColorMask(RC_FALSE, RC_FALSE, RC_FALSE, RC_FALSE);
  rcClearColor(1, 1, 1, 1);
  rcFinish();
  EXPECT_EQ(surface.pixels[0], 0xff8000ffu);
}

TEST_F(PictureTest, MultisampleOffTracesOneRayAPixel) {
  Settings settings;
  settings.samples = 4;
  useSettings(settings);
  EXPECT_EQ(integer(RC_SAMPLES), 4);
  EXPECT_EQ(integer(RC_SAMPLE_BUFFERS), 1);
  pixelCamera();
  paint(1, 1, 1);
  const auto edge = [&] {  // half of a pixel is covered, not its corner
    drawQuad({20.5f, -10, 80, 60});
    trace();
    return pixel(20, 24)[0];
  };
  EXPECT_EQ(edge(), 128);
  EXPECT_EQ(integer(RC_FRAME_RAYS), 4 * kWidth * kHeight);
  rcDisable(RC_MULTISAMPLE);
  EXPECT_EQ(integer(RC_SAMPLES), 0);
  EXPECT_EQ(integer(RC_SAMPLE_BUFFERS), 0);
  EXPECT_EQ(edge(), 0);
  EXPECT_EQ(integer(RC_FRAME_RAYS), kWidth * kHeight);
  rcEnable(RC_MULTISAMPLE);
  EXPECT_EQ(edge(), 128);
}

}  // namespace
}  // namespace rc::test
