// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcOrtho: rays side by side. [OpenGL ES 1.1, 2.10.2]
#include <functional>

#include "api/context_fixture.h"

namespace rc::test {
namespace {

class OrthoTest : public ContextTest {
 protected:
  static constexpr Rect kSquare{20.5f, 10.5f, 40.5f, 30.5f};

  void SetUp() override {
    ContextTest::SetUp();
    rcuLookAt(0, 0, 0, 0, 0, -1, 0, 1, 0);
    paint(1, 1, 1);
  }
  // Pixels show the world's x and y wherever z is; rays start at z = -zNear.
  void pixelWindow(float zNear = -100) { rcOrthof(0, kWidth, 0, kHeight, zNear, 100); }
  bool covered(int x, int y) const { return pixel(x, y) != kBlack; }
  bool seen(float z) {
    drawQuad(kSquare, z);
    trace();
    return covered(30, 20);
  }
};

TEST_F(OrthoTest, EdgesAreWhereTheyAreInTheWorld) {
  pixelWindow();
  for (float z : {0.0f, 50.0f, -99.0f, -5000.0f}) {
    drawQuad(kSquare, z);
    trace();
    for (int x = 0; x < kWidth; ++x) ASSERT_EQ(covered(x, 20), x > 20 && x <= 40) << x << " at " << z;
    for (int y = 0; y < kHeight; ++y) ASSERT_EQ(covered(30, y), y > 10 && y <= 30) << y << " at " << z;
  }
}

TEST_F(OrthoTest, EveryTypeOfNumbers) {
  const std::function<void()> kinds[] = {
      [] { rcOrtho(10, 42, 5, 29, -1, 1); }, [] { rcOrthof(10, 42, 5, 29, -1, 1); },
      [] { rcOrthox(10 * kFixedOne, 42 * kFixedOne, 5 * kFixedOne, 29 * kFixedOne, -kFixedOne, kFixedOne); }};
  for (const auto &window : kinds) {
    pixelWindow();
    window();
    drawQuad(kSquare, 0);  // two pixels a unit
    trace();
    EXPECT_FALSE(covered(20, 30));
    EXPECT_TRUE(covered(21, 30));
    EXPECT_TRUE(covered(60, 30));
    EXPECT_FALSE(covered(62, 30));
    EXPECT_CLEAN();
  }
}

TEST_F(OrthoTest, RaysStartAtZNearWhichMayLieBehindTheEye) {
  pixelWindow(-10);
  EXPECT_TRUE(seen(9));
  EXPECT_FALSE(seen(11));
  pixelWindow(0);
  EXPECT_FALSE(seen(1));
  EXPECT_TRUE(seen(-1));
  pixelWindow(20);
  EXPECT_FALSE(seen(-19));
  EXPECT_TRUE(seen(-21));
}

TEST_F(OrthoTest, ZFarCutsNothing) {
  rcOrthof(0, kWidth, 0, kHeight, 0, 1);
  EXPECT_TRUE(seen(-1000));
}

TEST_F(OrthoTest, TheWindowMayBeTurnedRound) {
  rcOrthof(kWidth, 0, 0, kHeight, -1, 1);
  drawQuad({1.5f, 1.5f, 10.5f, 40.5f}, 0);
  trace();
  EXPECT_TRUE(covered(60, 20));
  EXPECT_FALSE(covered(5, 20));
}

TEST_F(OrthoTest, FollowsTheLookAt) {
  rcuLookAt(0, 0, 50, 1, 0, 50, 0, 1, 0);  // along x: z grows to the left
  rcOrthof(-32, 32, 0, kHeight, -100, 100);
  drawTriangles({5, 0, 60, 5, 40, 60, 5, 0, 80, 5, 40, 60, 5, 40, 80, 5, 0, 80});
  trace();
  EXPECT_TRUE(covered(32 + 20, 20));
  EXPECT_FALSE(covered(32 - 20, 20));
}

TEST_F(OrthoTest, EachReplacesTheOther) {
  pixelWindow();
  EXPECT_TRUE(seen(50));  // behind the eye
  rcFrustumf(-1, 1, -1, 1, 1, 2);
  EXPECT_FALSE(seen(50));
  pixelWindow();
  EXPECT_TRUE(seen(50));
}

// Parallel rays meet a mirror at one angle everywhere.
TEST_F(OrthoTest, AMirrorShowsTheWorldAtItsSize) {
  pixelWindow(0);
  rcBindMaterial(1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  drawQuad({-100, -100, 200, 200}, -10);
  rcBindMaterial(0);
  drawQuad(kSquare, 500);
  trace();
  for (int x = 0; x < kWidth; ++x) ASSERT_EQ(covered(x, 20), x > 20 && x <= 40) << x;
}

TEST_F(OrthoTest, FogCountsFromThePlaneOfTheEye) {
  paint(1, 0, 0);
  rcEnable(RC_FOG);
  rcFogf(RC_FOG_MODE, RC_LINEAR);
  rcFogf(RC_FOG_END, 100);
  for (float zNear : {-100.0f, 0.0f, 20.0f}) {
    pixelWindow(zNear);
    EXPECT_TRUE(seen(-50));
    EXPECT_NEAR(pixel(30, 20)[0], 128, 1) << zNear;
  }
  pixelWindow();
  EXPECT_TRUE(seen(50));  // behind the eye
  EXPECT_EQ(pixel(30, 20)[0], 255);
}

TEST_F(OrthoTest, Errors) {
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrtho(1, 1, 0, 1, -1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrtho(0, 1, 2, 2, -1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrtho(0, 1, 0, 1, 3, 3));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(1, 1, 0, 1, -1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(0, 1, 2, 2, -1, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(0, 1, 0, 1, 3, 3));
  for (float bad : {kNan, kInf, -kInf}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(bad, 1, 0, 1, -1, 1));
    EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(0, 1, 0, bad, -1, 1));
    EXPECT_RAISES(RC_INVALID_VALUE, rcOrthof(0, 1, 0, 1, bad, 1));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthox(0, 0, 0, kFixedOne, 0, kFixedOne));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthox(0, kFixedOne, 5, 5, 0, kFixedOne));
  EXPECT_RAISES(RC_INVALID_VALUE, rcOrthox(0, kFixedOne, 0, kFixedOne, 7, 7));
}

}  // namespace
}  // namespace rc::test
