// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcCullFace and rcFrontFace, for each kind of ray. [OpenGL ES 1.1, 3.5.1]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class CullingTest : public ContextTest {
 protected:
  static constexpr Rect kAll{-300, -300, 400, 400};

  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
  }
  void cull(RCenum mode) {
    rcEnable(RC_CULL_FACE);
    rcCullFace(mode);
  }
  bool seen() {
    trace();
    return pixel(32, 24) != kBlack;
  }
};

TEST_F(CullingTest, InitialState) {
  EXPECT_FALSE(rcIsEnabled(RC_CULL_FACE));
  EXPECT_EQ(integer(RC_CULL_FACE_MODE), RC_BACK);
  EXPECT_EQ(integer(RC_FRONT_FACE), RC_CCW);
}

TEST_F(CullingTest, IsKept) {
  for (RCenum mode : {RC_FRONT, RC_BACK, RC_FRONT_AND_BACK}) {
    rcCullFace(RCenum(mode));
    EXPECT_EQ(integer(RC_CULL_FACE_MODE), RCint(mode));
    EXPECT_EQ(floats(RC_CULL_FACE_MODE, 1)[0], float(mode));
  }
  for (RCenum mode : {RC_CW, RC_CCW}) {
    rcFrontFace(RCenum(mode));
    RCfixed back = 0;
    rcGetFixedv(RC_FRONT_FACE, &back);
    EXPECT_EQ(back, RCfixed(mode)) << "a token is never scaled";
  }
  EXPECT_CLEAN();
}

TEST_F(CullingTest, Errors) {
  for (RCenum mode : {kNoToken, RCenum(RC_CW), RCenum(0)}) EXPECT_RAISES(RC_INVALID_ENUM, rcCullFace(mode));
  for (RCenum mode : {kNoToken, RCenum(RC_FRONT), RCenum(0)}) EXPECT_RAISES(RC_INVALID_ENUM, rcFrontFace(mode));
}

TEST_F(CullingTest, RaysOfTheEye) {
  for (const bool clockwise : {false, true}) {
    for (const RCenum front : {RC_CCW, RC_CW}) {
      for (const RCenum mode : {RC_FRONT, RC_BACK, RC_FRONT_AND_BACK}) {
        cull(RCenum(mode));
        rcFrontFace(RCenum(front));
        clockwise ? drawClockwiseQuad(kAll) : drawQuad(kAll);
        const bool isFront = clockwise == (front == RC_CW);
        const bool culled = mode == RC_FRONT_AND_BACK || (mode == RC_FRONT) == isFront;
        EXPECT_EQ(seen(), !culled) << clockwise << ' ' << front << ' ' << mode;
        rcDisable(RC_CULL_FACE);
        clockwise ? drawClockwiseQuad(kAll) : drawQuad(kAll);
        EXPECT_TRUE(seen()) << "off: " << clockwise << ' ' << front << ' ' << mode;
      }
    }
  }
}

TEST_F(CullingTest, IsCapturedByTheDraw) {
  cull(RC_FRONT);
  drawQuad(kAll);
  rcDisable(RC_CULL_FACE);
  EXPECT_FALSE(seen());
  drawQuad(kAll);
  cull(RC_FRONT);
  EXPECT_TRUE(seen());
}

TEST_F(CullingTest, BehindACulledSideOneSeesWhatIsThere) {
  paint(0, 1, 0);
  drawQuad(kAll, -20);
  cull(RC_FRONT);
  paint(1, 0, 0);
  drawQuad(kAll);
  trace();
  EXPECT_EQ(pixel(32, 24), (Colour{0, 255, 0}));
}

// The light comes along (-1, 0, -1): an occluder at z = 10 darkens the wall 10 to its left. The ray of the shadow
// meets the side that looks away from the light.
TEST_F(CullingTest, RaysOfShadow) {
  paintDiffuse(1, 1, 1);
  lightFrom(1, 0, 1, 0, 1);
  const int lit = int(256 * std::sqrt(0.5));
  const auto shadow = [&](RCenum mode) {
    rcDisable(RC_CULL_FACE);
    drawQuad(kAll);
    cull(mode);
    drawQuad({30, -50, 60, 100}, 10);
    trace();
    return pixel(24, 24)[0];
  };
  EXPECT_NEAR(shadow(RC_BACK), lit, 1);
  EXPECT_EQ(shadow(RC_FRONT), 0);
  EXPECT_NEAR(shadow(RC_FRONT_AND_BACK), lit, 1);
  rcFrontFace(RC_CW);
  EXPECT_NEAR(shadow(RC_FRONT), lit, 1);
  EXPECT_EQ(shadow(RC_BACK), 0);
}

// A mirror shows the back of what stands behind the eye and looks the eye's way round.
TEST_F(CullingTest, RaysOfAMirror) {
  const auto mirrored = [&](RCenum mode) {
    rcDisable(RC_CULL_FACE);
    rcBindMaterial(1);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
    drawQuad(kAll);
    rcBindMaterial(0);
    cull(mode);
    drawQuad(kAll, 128);
    return seen();
  };
  EXPECT_FALSE(mirrored(RC_BACK));
  EXPECT_TRUE(mirrored(RC_FRONT));
  EXPECT_FALSE(mirrored(RC_FRONT_AND_BACK));
  rcFrontFace(RC_CW);
  EXPECT_TRUE(mirrored(RC_BACK));
  EXPECT_FALSE(mirrored(RC_FRONT));
}

// Glass of index 2: entering at the front the ray at x = 52 goes on to x = 61.7 at z = -64, leaving to x = 99.6.
TEST_F(CullingTest, RefractionEntersAtTheFront) {
  const auto through = [&](RCenum front) {
    rcFrontFace(front);
    rcBindMaterial(1);
    rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 1);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, 2);
    drawQuad(kAll);
    rcBindMaterial(0);
    drawQuad({60, 0, 63, 48}, -64);
    trace();
    return pixel(52, 24) != kBlack;
  };
  EXPECT_TRUE(through(RC_CCW));
  EXPECT_FALSE(through(RC_CW));
}

}  // namespace
}  // namespace rc::test
