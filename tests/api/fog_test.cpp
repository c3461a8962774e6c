// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Fog: state, errors, and the colour at a known length of way. [OpenGL ES 1.1, 3.8]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class FogTest : public ContextTest {
 protected:
  // A red wall at z, blue fog that lets `left` through after 64 units.
  void redInBlue() {
    pixelCamera();
    paint(1, 0, 0);
    const float blue[] = {0, 0, 1, 1};
    rcFogfv(RC_FOG_COLOR, blue);
    rcEnable(RC_FOG);
  }
  void linear(float start, float end) {
    rcFogf(RC_FOG_MODE, RC_LINEAR);
    rcFogf(RC_FOG_START, start);
    rcFogf(RC_FOG_END, end);
  }
  void wall(float z = 0) {
    drawQuad({-200, -200, 300, 300}, z);
    trace();
  }
  // Red is the surface's share of the colour, blue the fog's.
  void expectLeft(double left, int x = 32, int y = 24) {
    EXPECT_NEAR(pixel(x, y)[0], std::min(255.0, 256 * left), 1);
    EXPECT_NEAR(pixel(x, y)[2], std::min(255.0, 256 * (1 - left)), 1);
  }
};

TEST_F(FogTest, InitialState) {
  EXPECT_FALSE(rcIsEnabled(RC_FOG));
  EXPECT_EQ(integer(RC_FOG_MODE), RC_EXP);
  EXPECT_EQ(floats(RC_FOG_DENSITY, 1), Values{1});
  EXPECT_EQ(floats(RC_FOG_START, 1), Values{0});
  EXPECT_EQ(floats(RC_FOG_END, 1), Values{1});
  EXPECT_EQ(floats(RC_FOG_COLOR, 4), (Values{0, 0, 0, 0}));
}

TEST_F(FogTest, NumbersAreKept) {
  for (RCenum name : {RC_FOG_DENSITY, RC_FOG_START, RC_FOG_END}) {
    rcFogf(RCenum(name), 2.5f);
    EXPECT_EQ(floats(RCenum(name), 1), Values{2.5f});
    EXPECT_EQ(integer(RCenum(name)), 3) << "to the nearest";
    rcFogx(RCenum(name), 3 * kFixedOne / 4);
    EXPECT_EQ(floats(RCenum(name), 1), Values{0.75f});
    const float number[] = {7};
    rcFogfv(RCenum(name), number);
    const RCfixed fixed[] = {5 * kFixedOne / 2};
    EXPECT_EQ(floats(RCenum(name), 1), Values{7});
    rcFogxv(RCenum(name), fixed);
    RCfixed back = 0;
    rcGetFixedv(RCenum(name), &back);
    EXPECT_EQ(back, fixed[0]);
    RCboolean flag = 9;
    rcGetBooleanv(RCenum(name), &flag);
    EXPECT_EQ(flag, RC_TRUE);
  }
  rcFogf(RC_FOG_START, -3);  // only the density has a sign
  EXPECT_EQ(floats(RC_FOG_START, 1), Values{-3});
  EXPECT_CLEAN();
}

TEST_F(FogTest, ModesAreTokensInEveryType) {
  for (RCenum mode : {RC_LINEAR, RC_EXP2, RC_EXP}) {
    rcFogf(RC_FOG_MODE, float(mode));
    EXPECT_EQ(integer(RC_FOG_MODE), RCint(mode));
    rcFogf(RC_FOG_MODE, mode == RC_EXP ? RC_LINEAR : RC_EXP);
    rcFogx(RC_FOG_MODE, RCfixed(mode));
    RCfixed back = 0;
    rcGetFixedv(RC_FOG_MODE, &back);
    EXPECT_EQ(back, RCfixed(mode)) << "never scaled";
    const float number[] = {RC_LINEAR};
    rcFogfv(RC_FOG_MODE, number);
    EXPECT_EQ(integer(RC_FOG_MODE), RC_LINEAR);
    const RCfixed fixed[] = {RCfixed(mode)};
    rcFogxv(RC_FOG_MODE, fixed);
    EXPECT_EQ(integer(RC_FOG_MODE), RCint(mode));
  }
  EXPECT_CLEAN();
}

TEST_F(FogTest, TheColourIsClampedAndConverted) {
  const float colour[] = {2, -1, 0.2f, 0.5f};
  rcFogfv(RC_FOG_COLOR, colour);
  EXPECT_EQ(floats(RC_FOG_COLOR, 4), (Values{1, 0, 0.2f, 0.5f}));
  RCint whole[4];
  rcGetIntegerv(RC_FOG_COLOR, whole);
  EXPECT_EQ(whole[0], 255);
  EXPECT_EQ(whole[1], 0);
  EXPECT_EQ(whole[2], 51);
  const RCfixed fixed[] = {kFixedOne / 4, kFixedOne, 0, kFixedOne * 3};
  rcFogxv(RC_FOG_COLOR, fixed);
  EXPECT_EQ(floats(RC_FOG_COLOR, 4), (Values{0.25f, 1, 0, 1}));
  RCfixed back[4];
  rcGetFixedv(RC_FOG_COLOR, back);
  EXPECT_EQ(back[0], kFixedOne / 4);
}

TEST_F(FogTest, Errors) {
  const float minus[] = {-1}, numbers[4] = {};
  const RCfixed fixedMinus[] = {-kFixedOne}, fixed[4] = {};
  for (RCenum name : {kNoToken, RCenum(RC_FOG), RCenum(RC_FOG_HINT)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcFogf(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcFogx(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcFogfv(name, numbers));
    EXPECT_RAISES(RC_INVALID_ENUM, rcFogxv(name, fixed));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcFogf(RC_FOG_COLOR, 1));  // four values
  EXPECT_RAISES(RC_INVALID_ENUM, rcFogx(RC_FOG_COLOR, 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcFogf(RC_FOG_MODE, RC_NEAREST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcFogx(RC_FOG_MODE, RC_NEAREST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcFogf(RC_FOG_MODE, kNan));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFogf(RC_FOG_DENSITY, -0.5f));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFogf(RC_FOG_DENSITY, kNan));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFogx(RC_FOG_DENSITY, -1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFogfv(RC_FOG_DENSITY, minus));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFogxv(RC_FOG_DENSITY, fixedMinus));
  rcFogfv(RC_FOG_COLOR, nullptr);
  rcFogxv(RC_FOG_COLOR, nullptr);
  EXPECT_CLEAN();
}

TEST_F(FogTest, LinearFadesBetweenStartAndEnd) {
  redInBlue();
  const struct {
    float start, end;
    double left;
  } cases[] = {{0, 128, 0.5}, {32, 96, 0.5},   {64, 128, 1},  {0, 64, 0},
               {0, 32, 0},    {48, 112, 0.75}, {128, 0, 0.5}, {-64, 192, 0.5}};
  for (const auto &[start, end, left] : cases) {
    linear(start, end);
    wall();
    expectLeft(left);
  }
  linear(50, 50);  // a step
  wall();
  expectLeft(0);
  linear(80, 80);
  wall();
  expectLeft(1);
}

TEST_F(FogTest, ExponentialModes) {
  redInBlue();
  rcFogf(RC_FOG_DENSITY, std::log(2.0f) / 64);
  wall();
  expectLeft(0.5);
  wall(-64);  // twice as far
  expectLeft(0.25);
  rcFogf(RC_FOG_MODE, RC_EXP2);
  rcFogf(RC_FOG_DENSITY, std::sqrt(std::log(2.0f)) / 64);
  wall();
  expectLeft(0.5);
  wall(-64);
  expectLeft(0.0625);
}

// The length of the ray, not the depth.
TEST_F(FogTest, TheWayIsMeasuredAlongTheRay) {
  redInBlue();
  linear(0, 160);
  wall();
  expectLeft(1 - std::hypot(32, 64) / 160, 0, 24);
  expectLeft(1 - std::hypot(32, 24, 64) / 160, 0, 0);
}

TEST_F(FogTest, AMirrorAddsToTheWay) {
  redInBlue();
  linear(0, 320);
  rcBindMaterial(1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  drawQuad({-200, -200, 300, 300}, 0);
  rcBindMaterial(0);
  wall(96);  // behind the eye: 64 to the mirror, 96 back
  expectLeft(0.5);
}

TEST_F(FogTest, ATransparentLayerIsNoStep) {
  redInBlue();
  linear(0, 256);
  rcBindMaterial(1);
  rcEnable(RC_TEXTURE_2D);
  loadRgba(9, 9, 9, 0);
  drawQuad({-200, -200, 300, 300}, 0);
  rcBindMaterial(0);
  wall(-64);
  expectLeft(0.5);
}

TEST_F(FogTest, TheBackgroundKeepsItsColour) {
  redInBlue();
  linear(0, 1);
  rcClearColor(0.5f, 0.25f, 0, 0);
  drawQuad({0, 0, 20, 48});
  trace();
  EXPECT_EQ(pixel(40, 24), (Colour{128, 64, 0}));
  EXPECT_EQ(pixel(10, 24), (Colour{0, 0, 255}));
  // What a mirror shows of it fades on the way to the mirror only.
  linear(0, 128);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  wall();
  EXPECT_EQ(pixel(32, 24), (Colour{64, 32, 128}));
}

TEST_F(FogTest, WhatIsNotThereHasNone) {
  redInBlue();
  linear(0, 128);
  rcClearColor(0, 1, 0, 0);
  rcEnable(RC_CULL_FACE);
  drawClockwiseQuad({0, 0, 16, 48});
  rcDisable(RC_CULL_FACE);
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 200);
  rcEnable(RC_ALPHA_TEST);
  rcAlphaFunc(RC_LESS, 0.5f);
  loadRgba(200, 0, 0, 100);
  drawQuad({16, 0, 32, 48});  // fails the test
  rcDisable(RC_ALPHA_TEST);
  drawQuad({40, 0, 56, 48});  // half of it is there
  trace();
  for (int x : {8, 24, 36}) EXPECT_EQ(pixel(x, 24), (Colour{0, 255, 0})) << x;
  const Colour half = pixel(48, 24);
  const double left = 1 - std::hypot(64, 16) / 128;
  EXPECT_NEAR(half[0], 100 * left, 1);
  EXPECT_NEAR(half[1], 128, 1) << "the background has no fog";
  EXPECT_NEAR(half[2], 128 * (1 - left), 1);
}

TEST_F(FogTest, OffThereIsNone) {
  redInBlue();
  rcDisable(RC_FOG);
  wall();
  expectLeft(1);
}

}  // namespace
}  // namespace rc::test
