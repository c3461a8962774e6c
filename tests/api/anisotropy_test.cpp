// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Stripes that run away from the eye stay apart on a floor that is seen at a slant, if their texture may be read by
// several samples. [docs/extensions/RC_RCX_anisotropy.md]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class AnisotropyTest : public ContextTest {
 protected:
  static constexpr int kTexels = 64;

  // A floor of stripes along z, one bright and one dark each unit.
  void drawStripes(RCint anisotropy) {
    rcMatrixMode(RC_PROJECTION);
    rcLoadIdentity();
    rcuPerspective(60, float(kWidth) / kHeight, 0.01f, 1000);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcuLookAt(0, 0.5f, 0, 0, 0.5f, -1, 0, 1, 0);
    std::vector<RCubyte> rgb;
    for (int i = 0; i < kTexels * kTexels; ++i) rgb.insert(rgb.end(), 3, i % kTexels < kTexels / 2 ? 255 : 0);
    rcEnable(RC_TEXTURE_2D);
    rcEnable(RC_USE_TEXTURE_ONLY);
    rcBindTexture(RC_TEXTURE_2D, 4);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_LINEAR);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, kTexels, kTexels, 0, RC_RGB, RC_UNSIGNED_BYTE, rgb.data());
    constexpr float kFar = 100;
    const float corners[] = {-kFar, 0, kFar, kFar, 0, kFar, kFar, 0, -kFar, -kFar, 0, -kFar};
    const float coordinates[] = {0, 0, 2 * kFar, 0, 2 * kFar, 2 * kFar, 0, 2 * kFar};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, corners);
    rcTexCoordPointer(2, RC_FLOAT, 0, coordinates);
    rcDrawArrays(RC_TRIANGLE_FAN, 0, 4);
    rcFinish();
  }

  // Between the brightest and the darkest pixel of a row.
  int contrast(int row) {
    int least = 255, most = 0;
    for (int x = 0; x < kWidth; ++x) {
      least = std::min(least, int(pixel(x, row)[0]));
      most = std::max(most, int(pixel(x, row)[0]));
    }
    return most - least;
  }
};

// Four rows below the horizon a pixel is a third of a stripe wide, and many stripes long.
TEST_F(AnisotropyTest, KeepsStripesApart) {
  constexpr int kRow = kHeight / 2 - 4;
  drawStripes(1);
  const int blurred = contrast(kRow);
  drawStripes(16);
  EXPECT_LT(blurred, 80);
  EXPECT_GT(contrast(kRow), 160);
}

TEST_F(AnisotropyTest, IsOffWithoutMipLevels) {
  rcHint(RC_MIPMAP_HINT, RC_NICEST);  // level 0 alone
  drawStripes(1);
  const std::vector<uint32_t> without = surface.pixels;
  drawStripes(16);
  EXPECT_EQ(surface.pixels, without);
}

}  // namespace
}  // namespace rc::test
