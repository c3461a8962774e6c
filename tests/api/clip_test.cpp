// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Clip planes: state, errors, and the edge at the computed pixel. [OpenGL ES 1.1, 2.11]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class ClipTest : public ContextTest {
 protected:
  static constexpr Rect kSquare{10, 10, 50, 40}, kAll{-300, -300, 400, 400};

  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
  }
  void plane(int i, float a, float b, float c, float d) {
    const float equation[] = {a, b, c, d};
    rcClipPlanef(RC_CLIP_PLANE0 + RCenum(i), equation);
    rcEnable(RC_CLIP_PLANE0 + RCenum(i));
  }
  bool covered(int x, int y) const { return pixel(x, y) != kBlack; }
};

TEST_F(ClipTest, InitialState) {
  EXPECT_EQ(integer(RC_MAX_CLIP_PLANES), 6);
  for (RCenum name = RC_CLIP_PLANE0; name <= RC_CLIP_PLANE5; ++name) {
    EXPECT_FALSE(rcIsEnabled(name));
    EXPECT_EQ(clipPlane(name), (Values{0, 0, 0, 0}));
  }
}

TEST_F(ClipTest, PlanesAreKeptOneByOne) {
  for (RCenum name = RC_CLIP_PLANE0; name <= RC_CLIP_PLANE5; ++name) {
    const float n = float(name - RC_CLIP_PLANE0);
    const float equation[] = {n, 2, -3, 0.5f};
    rcClipPlanef(name, equation);
  }
  for (RCenum name = RC_CLIP_PLANE0; name <= RC_CLIP_PLANE5; ++name) {
    EXPECT_EQ(clipPlane(name), (Values{float(name - RC_CLIP_PLANE0), 2, -3, 0.5f}));
  }
  const RCfixed fixed[] = {kFixedOne, -kFixedOne / 2, 0, 7 * kFixedOne};
  rcClipPlanex(RC_CLIP_PLANE3, fixed);
  EXPECT_EQ(clipPlane(RC_CLIP_PLANE3), (Values{1, -0.5f, 0, 7}));
  RCfixed back[4];
  rcGetClipPlanex(RC_CLIP_PLANE3, back);
  EXPECT_TRUE(std::equal(fixed, fixed + 4, back));
  EXPECT_CLEAN();
}

TEST_F(ClipTest, TheModelviewOfTheCallTakesThemToTheWorld) {
  rcTranslatef(10, 0, 0);
  plane(0, 1, 0, 0, -20);
  EXPECT_EQ(clipPlane(RC_CLIP_PLANE0), (Values{1, 0, 0, -30}));
  rcLoadIdentity();
  EXPECT_EQ(clipPlane(RC_CLIP_PLANE0), (Values{1, 0, 0, -30})) << "fixed by the call";
  rcScalef(2, 1, 1);
  plane(0, 1, 0, 0, -20);
  EXPECT_EQ(clipPlane(RC_CLIP_PLANE0), (Values{0.5f, 0, 0, -20}));
  rcLoadIdentity();
  rcRotatef(90, 0, 0, 1);  // x becomes y
  plane(0, 1, 0, 0, -5);
  const Values turned = clipPlane(RC_CLIP_PLANE0);
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(turned[i], (Values{0, 1, 0, -5}[i]), 1e-6);
}

TEST_F(ClipTest, Errors) {
  float numbers[4] = {7, 7, 7, 7};
  RCfixed fixed[4] = {7, 7, 7, 7};
  for (RCenum name : {kNoToken, RCenum(RC_CLIP_PLANE0 - 1), RCenum(RC_CLIP_PLANE5 + 1), RCenum(0)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcClipPlanef(name, numbers));
    EXPECT_RAISES(RC_INVALID_ENUM, rcClipPlanex(name, fixed));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetClipPlanef(name, numbers));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetClipPlanex(name, fixed));
  }
  EXPECT_EQ(numbers[0], 7);
  EXPECT_EQ(fixed[3], 7);
  rcClipPlanef(RC_CLIP_PLANE0, nullptr);
  rcClipPlanex(RC_CLIP_PLANE0, nullptr);
  rcGetClipPlanef(RC_CLIP_PLANE0, nullptr);
  rcGetClipPlanex(RC_CLIP_PLANE0, nullptr);
  EXPECT_CLEAN();
}

TEST_F(ClipTest, TheEdgeIsWhereThePlaneIs) {
  plane(2, 1, 0, 0, -30.5f);
  drawQuad(kSquare);
  trace();
  for (int x = 0; x < 50; ++x) EXPECT_EQ(covered(x, 20), x > 30) << x;
}

TEST_F(ClipTest, SeveralPlanesCutTogether) {
  plane(0, 1, 0, 0, -20.5f);
  plane(3, 0, -1, 0, 30.5f);
  plane(5, -1, -1, 0, 60.5f);  // x + y <= 60.5
  drawQuad(kSquare);
  trace();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inSquare = x >= 10 && x < 50 && y >= 10 && y < 40;
      // The square's own sides lie on pixels' rays.
      if (x == 10 || x == 50 || y == 10 || y == 40) continue;
      ASSERT_EQ(covered(x, y), inSquare && x > 20 && y <= 30 && x + y <= 60) << x << ' ' << y;
    }
  }
}

TEST_F(ClipTest, PlanesThatAreOffCutNothing) {
  plane(0, 1, 0, 0, -30.5f);
  rcDisable(RC_CLIP_PLANE0);
  rcEnable(RC_CLIP_PLANE1);  // (0, 0, 0, 0): nothing is behind it
  drawQuad(kSquare);
  plane(2, 0, 0, 0, -1);  // after the draw: everything would be
  trace();
  EXPECT_TRUE(covered(12, 20));
  EXPECT_TRUE(covered(45, 20));
}

TEST_F(ClipTest, WhatLiesBehindIsNotInTheScene) {
  plane(0, 0, 0, 1, -1);
  drawQuad(kSquare);
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 0);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 0) << "as the program wants it";
  EXPECT_EQ(context->lastFrame().skipped.clipped, 2u);
}

TEST_F(ClipTest, ColoursGoOnAcrossTheCut) {
  const std::vector<float> colours{0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1, 1, 1};
  drawColouredQuad(kSquare, colours);
  trace();
  const Colour whole = pixel(40, 20);
  plane(0, 1, 0, 0, -35.25f);
  plane(1, -1, -0.3f, 0, 50);
  drawColouredQuad(kSquare, colours);
  trace();
  EXPECT_FALSE(covered(35, 20));
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(pixel(40, 20)[i], whole[i], 1);
}

// Normals of any length: what is left of a triangle is lit as it was.
TEST_F(ClipTest, NormalsGoOnAcrossTheCut) {
  paintDiffuse(1, 1, 1);
  lightFrom(0, 0, 1, 0, 0.9f);
  const float normals[] = {-0.9f, 0, 0.5f, 9, 0, 5, 9, 0, 5, 0, 0, 0};
  const auto draw = [&] {
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcNormalPointer(RC_FLOAT, 0, normals);
    drawQuad(kSquare);
    rcDisableClientState(RC_NORMAL_ARRAY);
    trace();
  };
  draw();
  const Colour below = pixel(40, 15), above = pixel(40, 35);
  EXPECT_NE(above, below);
  plane(0, 1, 0, 0, -25.25f);
  plane(1, -1, -0.3f, 0, 54);
  draw();
  EXPECT_FALSE(covered(25, 20));
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(pixel(40, 15)[i], below[i], 1);
    EXPECT_NEAR(pixel(40, 35)[i], above[i], 1);
  }
}

TEST_F(ClipTest, TextureCoordinatesGoOnAcrossTheCut) {
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadColumns({200, 0, 0}, {0, 0, 200});
  plane(0, 1, 0, 0, -21.5f);
  drawTexturedQuad(kSquare);  // the columns change at x = 30
  trace();
  EXPECT_EQ(pixel(21, 20), kBlack);
  EXPECT_EQ(pixel(27, 20), (Colour{200, 0, 0}));
  EXPECT_EQ(pixel(34, 20), (Colour{0, 0, 200}));
}

// The light comes along (-1, 0, -1): an occluder at z = 10 darkens the wall 10 to its left.
TEST_F(ClipTest, TheShadowIsCutToo) {
  paintDiffuse(1, 1, 1);
  lightFrom(1, 0, 1, 0, 1);
  plane(0, 1, 0, 0, -35);
  rcDisable(RC_CLIP_PLANE0);
  drawQuad(kAll);
  rcEnable(RC_CLIP_PLANE0);
  drawQuad({30, -50, 60, 100}, 10);
  trace();
  EXPECT_NEAR(pixel(24, 24)[0], 256 * std::sqrt(0.5), 1) << "its shadow was cut away";
  EXPECT_EQ(pixel(26, 24)[0], 0);
}

// A mirror in the picture plane shows x = 32 + 3 (p - 32) of z = 128 at pixel p.
TEST_F(ClipTest, WhatAMirrorShowsIsCutToo) {
  rcBindMaterial(1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  drawQuad(kAll);
  rcBindMaterial(0);
  plane(0, 1, 0, 0, -45.5f);  // p = 36.5
  drawQuad(kAll, 128);
  trace();
  EXPECT_FALSE(covered(36, 24));
  EXPECT_TRUE(covered(37, 24));
}

TEST_F(ClipTest, BadCoordinatesHarmNothing) {
  plane(0, 1, 0, 0, -20.5f);
  drawTriangles({kNan, 0, 0, 40, 0, 0, 0, 40, 0, kInf, 0, 0, 40, 0, 0, 0, 40, 0});
  plane(1, kNan, 0, 0, 0);
  drawQuad(kSquare);
  plane(1, kInf, 0, 0, -kInf);
  drawQuad(kSquare);
  rcFinish();
  EXPECT_EQ(context->lastFrame().skipped.notFinite, 2u);
  EXPECT_CLEAN();
}

}  // namespace
}  // namespace rc::test
