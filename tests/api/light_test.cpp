// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Lights: parameters, errors, and what they show. [spec 3.3, 4]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class LightTest : public ContextTest {
 protected:
  // LIGHT0 alone, shining only with `diffuse`, on a white surface that fills the picture.
  void wallUnder(float diffuse) {
    pixelCamera();
    const float black[] = {0, 0, 0}, white[] = {1, 1, 1}, bright[] = {diffuse, diffuse, diffuse};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, bright);
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    drawQuad({-10, -10, 80, 60});
  }

  void place(float x, float y, float z, float w) {
    const float position[] = {x, y, z, w};
    rcLightfv(RC_LIGHT0, RC_POSITION, position);
  }
};

constexpr RCenum kLightScalars[] = {RC_SPOT_EXPONENT,        RC_SPOT_INNER_CONE,    RC_SPOT_OUTER_CONE,
                                    RC_CONSTANT_ATTENUATION, RC_LINEAR_ATTENUATION, RC_QUADRATIC_ATTENUATION,
                                    RC_START_ATTENUATION,    RC_END_ATTENUATION,    RC_SPOT_CUTOFF};
constexpr RCenum kVectors[] = {RC_AMBIENT,  RC_DIFFUSE,        RC_SPECULAR,
                               RC_POSITION, RC_SPOT_DIRECTION, RC_ATTENUATION_RANGE};

TEST_F(LightTest, InitialState) {
  EXPECT_EQ(integer(RC_MAX_LIGHTS), 8);
  EXPECT_FALSE(rcIsEnabled(RC_LIGHTING));
  for (RCenum name = RC_LIGHT0; name <= RC_LIGHT7; ++name) {
    EXPECT_FALSE(rcIsEnabled(name));
    EXPECT_EQ(light(name, RC_AMBIENT, 3), (Values{1, 1, 1}));
    EXPECT_EQ(light(name, RC_DIFFUSE, 4), (Values{0.1f, 0.1f, 0.1f, 0}));
    EXPECT_EQ(light(name, RC_SPECULAR, 4), (Values{0, 0, 0, 0}));
    EXPECT_EQ(light(name, RC_POSITION, 4), (Values{0, 0, 1, 0}));
    EXPECT_EQ(light(name, RC_SPOT_DIRECTION, 3), (Values{0, 0, 0}));
    EXPECT_EQ(light(name, RC_SPOT_EXPONENT, 1), Values{0});
    EXPECT_EQ(light(name, RC_SPOT_INNER_CONE, 1), Values{0});
    EXPECT_EQ(light(name, RC_SPOT_OUTER_CONE, 1), Values{180});
    EXPECT_EQ(light(name, RC_SPOT_CUTOFF, 1), Values{180});
    EXPECT_EQ(light(name, RC_ATTENUATION_RANGE, 2), (Values{0, 0}));
    EXPECT_EQ(light(name, RC_CONSTANT_ATTENUATION, 1), Values{1});
    EXPECT_EQ(light(name, RC_LINEAR_ATTENUATION, 1), Values{0});
    EXPECT_EQ(light(name, RC_QUADRATIC_ATTENUATION, 1), Values{0});
  }
}

TEST_F(LightTest, ScalarsAreKept) {
  for (size_t i = 0; i < std::size(kLightScalars); ++i) {
    const float number = float(i + 1);
    rcLightf(RC_LIGHT3, kLightScalars[i], number);
    EXPECT_EQ(light(RC_LIGHT3, kLightScalars[i], 1), Values{number});
    rcLightx(RC_LIGHT3, kLightScalars[i], kFixedOne / 2);
    EXPECT_EQ(light(RC_LIGHT3, kLightScalars[i], 1), Values{0.5f});
    const float vector[] = {number + 1};
    rcLightfv(RC_LIGHT3, kLightScalars[i], vector);
    EXPECT_EQ(light(RC_LIGHT3, kLightScalars[i], 1), Values{number + 1});
    const RCfixed fixed[] = {3 * kFixedOne};
    rcLightxv(RC_LIGHT3, kLightScalars[i], fixed);
    RCfixed back = 0;
    rcGetLightxv(RC_LIGHT3, kLightScalars[i], &back);
    EXPECT_EQ(back, 3 * kFixedOne);
  }
  EXPECT_EQ(light(RC_LIGHT2, RC_SPOT_EXPONENT, 1), Values{0});
  EXPECT_CLEAN();
}

TEST_F(LightTest, ColoursAreClampedAndThreeValuesAreRead) {
  const auto three = std::make_unique<float[]>(3);  // nothing may be read beyond
  three[0] = 0.25f, three[1] = 2, three[2] = -1;
  for (RCenum pname : {RC_AMBIENT, RC_DIFFUSE, RC_SPECULAR}) {
    rcLightfv(RC_LIGHT1, RCenum(pname), three.get());
    EXPECT_EQ(light(RC_LIGHT1, RCenum(pname), 3), (Values{0.25f, 1, 0}));
  }
  const auto fixed = std::make_unique<RCfixed[]>(3);
  fixed[0] = fixed[1] = fixed[2] = kFixedOne / 4;
  rcLightxv(RC_LIGHT1, RC_SPECULAR, fixed.get());
  EXPECT_EQ(light(RC_LIGHT1, RC_SPECULAR, 3), (Values{0.25f, 0.25f, 0.25f}));
}

TEST_F(LightTest, CutoffIsTheOuterConeAndLeavesTheInnerAlone) {
  rcLightf(RC_LIGHT0, RC_SPOT_INNER_CONE, 20);
  rcLightf(RC_LIGHT0, RC_SPOT_CUTOFF, 45);
  EXPECT_EQ(light(RC_LIGHT0, RC_SPOT_OUTER_CONE, 1), Values{45});
  EXPECT_EQ(light(RC_LIGHT0, RC_SPOT_INNER_CONE, 1), Values{20});
  rcLightf(RC_LIGHT0, RC_SPOT_OUTER_CONE, 180);
  EXPECT_EQ(light(RC_LIGHT0, RC_SPOT_CUTOFF, 1), Values{180});
}

TEST_F(LightTest, TheRangeIsItsStartAndEnd) {
  const float range[] = {3, 7};
  rcLightfv(RC_LIGHT0, RC_ATTENUATION_RANGE, range);
  EXPECT_EQ(light(RC_LIGHT0, RC_START_ATTENUATION, 1), Values{3});
  EXPECT_EQ(light(RC_LIGHT0, RC_END_ATTENUATION, 1), Values{7});
}

TEST_F(LightTest, PositionAndDirectionPassThroughTheModelview) {
  rcTranslatef(10, 20, 30);
  rcScalef(2, 2, 2);
  place(1, 2, 3, 1);
  const float direction[] = {0, 0, -1};
  rcLightfv(RC_LIGHT0, RC_SPOT_DIRECTION, direction);
  rcLoadIdentity();
  EXPECT_EQ(light(RC_LIGHT0, RC_POSITION, 4), (Values{12, 24, 36, 1}));
  EXPECT_EQ(light(RC_LIGHT0, RC_SPOT_DIRECTION, 3), (Values{0, 0, -2}));
  rcTranslatef(10, 20, 30);
  place(1, 2, 3, 0);
  EXPECT_EQ(light(RC_LIGHT0, RC_POSITION, 4), (Values{1, 2, 3, 0}));
}

TEST_F(LightTest, NameAndParameterErrors) {
  float values[4] = {};
  RCfixed fixed[4] = {};
  for (RCenum name : {RCenum(RC_LIGHT0 - 1), RCenum(RC_LIGHT7 + 1), RCenum(RC_LIGHT0 + 1023), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightf(name, RC_SPOT_EXPONENT, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightx(name, RC_SPOT_EXPONENT, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightfv(name, RC_AMBIENT, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightxv(name, RC_AMBIENT, fixed));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetLightfv(name, RC_AMBIENT, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetLightxv(name, RC_AMBIENT, fixed));
  }
  for (RCenum pname : {RCenum(RC_EMISSION), RCenum(RC_SHININESS), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightf(RC_LIGHT0, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightx(RC_LIGHT0, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightfv(RC_LIGHT0, pname, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightxv(RC_LIGHT0, pname, fixed));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetLightfv(RC_LIGHT0, pname, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetLightxv(RC_LIGHT0, pname, fixed));
  }
  for (RCenum pname : kVectors) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightf(RC_LIGHT0, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightx(RC_LIGHT0, pname, 1));
  }
}

TEST_F(LightTest, RangeErrors) {
  for (RCenum pname : kLightScalars) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightf(RC_LIGHT0, pname, -0.5f));
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightf(RC_LIGHT0, pname, kNan));
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightx(RC_LIGHT0, pname, -kFixedOne));
    const float values[] = {-1};
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightfv(RC_LIGHT0, pname, values));
    const RCfixed fixed[] = {-1};
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightxv(RC_LIGHT0, pname, fixed));
  }
  for (RCenum cone : {RC_SPOT_INNER_CONE, RC_SPOT_OUTER_CONE, RC_SPOT_CUTOFF}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightf(RC_LIGHT0, RCenum(cone), 90.5f));
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightf(RC_LIGHT0, RCenum(cone), 179));
    EXPECT_RAISES(RC_INVALID_VALUE, rcLightf(RC_LIGHT0, RCenum(cone), 181));
    rcLightf(RC_LIGHT0, RCenum(cone), 90);
    rcLightf(RC_LIGHT0, RCenum(cone), 0);
    EXPECT_CLEAN();
  }
  const float range[] = {1, -1};
  EXPECT_RAISES(RC_INVALID_VALUE, rcLightfv(RC_LIGHT0, RC_ATTENUATION_RANGE, range));
}

TEST_F(LightTest, NullPointersAreHarmless) {
  EXPECT_RAISES(RC_INVALID_VALUE, rcLightfv(RC_LIGHT0, RC_AMBIENT, nullptr));
  EXPECT_RAISES(RC_INVALID_VALUE, rcLightxv(RC_LIGHT0, RC_AMBIENT, nullptr));
  rcGetLightfv(RC_LIGHT0, RC_AMBIENT, nullptr);
  rcGetLightxv(RC_LIGHT0, RC_AMBIENT, nullptr);
  EXPECT_CLEAN();
}

// Default light: ambient 1 and diffuse 0.1 at the eye; the middle pixel looks straight at the wall.
TEST_F(LightTest, WithoutLightsADefaultOneShinesFromTheEye) {
  pixelCamera();
  const float half[] = {0.5f, 0.5f, 0.5f};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, half);
  drawQuad({-10, -10, 80, 60});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{140, 140, 140}));  // 256 * 0.5 * 1.1 = 140.8
  rcEnable(RC_LIGHTING);                              // no light is on
  drawQuad({-10, -10, 80, 60});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{140, 140, 140}));
  rcDisable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  const float black[] = {0, 0, 0};
  rcLightfv(RC_LIGHT0, RC_AMBIENT, black);
  drawQuad({-10, -10, 80, 60});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{140, 140, 140}));
}

TEST_F(LightTest, OldProfilesHaveTheDefaultLightAtZ1) {
  useProfile("1000");
  pixelCamera();
  const float black[] = {0, 0, 0}, white[] = {1, 1, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
  drawQuad({-10, -10, 80, 60});
  rcFinish();
  EXPECT_EQ(pixel(0, 0), (Colour{25, 25, 25}));  // 256 * 0.1, straight below the light
  EXPECT_EQ(pixel(32, 24), kBlack);              // 256 * 0.1 / sqrt(1601) = 0.6
}

TEST_F(LightTest, DirectionalLightFollowsTheCosine) {
  wallUnder(0.5f);
  place(0, 0.6f, 0.8f, 0);
  rcFinish();
  EXPECT_NEAR(pixel(32, 24)[0], 102, 1);  // 256 * 0.5 * 0.8 = 102.4, and the ambient colour is black
  EXPECT_EQ(pixel(5, 5), pixel(60, 40));
}

TEST_F(LightTest, AmbientIsTheSumOverTheLightsAndShadowLeavesIt) {
  pixelCamera();
  const float quarter[] = {0.25f, 0.25f, 0.25f}, black[] = {0, 0, 0};
  paint(1, 1, 1);
  rcEnable(RC_LIGHTING);
  for (RCenum name : {RC_LIGHT2, RC_LIGHT5}) {
    rcLightfv(RCenum(name), RC_AMBIENT, quarter);
    rcLightfv(RCenum(name), RC_DIFFUSE, black);
    rcEnable(RCenum(name));
  }
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{128, 128, 128}));
}

TEST_F(LightTest, AttenuationDividesByTheDistance) {
  wallUnder(1);
  place(32, 24, 4, 1);
  rcLightf(RC_LIGHT0, RC_CONSTANT_ATTENUATION, 1);
  rcLightf(RC_LIGHT0, RC_LINEAR_ATTENUATION, 0.75f);  // 1 / (1 + 0.75 * 4)
  rcFinish();
  EXPECT_NEAR(pixel(32, 24)[0], 64, 1);
  rcLightf(RC_LIGHT0, RC_LINEAR_ATTENUATION, 0);
  rcLightf(RC_LIGHT0, RC_QUADRATIC_ATTENUATION, 7.0f / 16);  // 1 / (1 + 7)
  rcFinish();
  EXPECT_NEAR(pixel(32, 24)[0], 32, 1);
}

TEST_F(LightTest, TheRangeFallsLinearly) {
  wallUnder(1);
  place(32, 24, 4, 1);
  const struct {
    float start, end;
    int expected;
  } cases[] = {{0, 8, 128}, {4, 8, 255}, {2, 4, 0}, {3, 7, 192}, {8, 8, 255}, {9, 1, 255}};
  for (const auto &[start, end, expected] : cases) {
    const float range[] = {start, end};
    rcLightfv(RC_LIGHT0, RC_ATTENUATION_RANGE, range);
    rcFinish();
    EXPECT_NEAR(pixel(32, 24)[0], expected, 1) << start << " ... " << end;
  }
}

TEST_F(LightTest, ASpotShinesWithinItsCones) {
  wallUnder(1);
  place(32, 24, 20, 1);
  const float down[] = {0, 0, -1};
  rcLightfv(RC_LIGHT0, RC_SPOT_DIRECTION, down);
  rcLightf(RC_LIGHT0, RC_SPOT_INNER_CONE, 20);
  rcLightf(RC_LIGHT0, RC_SPOT_OUTER_CONE, 30);  // 11.5 pixels
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(32 + 13, 24), kBlack);
  const double cosine = std::cos(std::atan(5.0 / 20));  // inside the inner cone only N.L counts
  EXPECT_NEAR(pixel(32 + 5, 24)[0], 256 * cosine, 1);
  place(0, 0, 1, 0);  // a directional light is no spot
  rcFinish();
  EXPECT_EQ(pixel(2, 2), (Colour{255, 255, 255}));
}

TEST_F(LightTest, AShadowIsCastWhileShadowsAreOn) {
  wallUnder(0.5f);
  place(0, 0, 1, 0);
  drawQuad({0, 0, 10, 10}, 100);  // behind the viewer
  rcFinish();
  EXPECT_EQ(pixel(5, 5), kBlack);
  EXPECT_EQ(pixel(40, 40), (Colour{128, 128, 128}));
  rcDisable(RC_USE_SHADOW);
  rcFinish();
  EXPECT_EQ(pixel(5, 5), (Colour{128, 128, 128}));
}

// The shadow's edge: 5 pixels from below the light, magnified by h / (h - 100). Rays of the near lights start at them.
TEST_F(LightTest, PointLightsCastShadowsFromNearAndFar) {
  wallUnder(0.5f);
  drawQuad({0, 0, 10, 10}, 100);
  for (const auto &[height, edge] : {std::pair{150.0f, 20}, {200, 15}, {1e3f, 10}, {1e4f, 10}, {1e6f, 10}}) {
    place(5, 5, height, 1);
    rcFinish();
    EXPECT_EQ(pixel(edge - 2, 5), kBlack) << height;
    EXPECT_NEAR(pixel(edge + 2, 5)[0], 128, 2) << height;
  }
}

TEST_F(LightTest, TheSecondGenerationHas1024) {
  useProfile("mc");
  EXPECT_EQ(integer(RC_MAX_LIGHTS), 1024);
  const RCenum last = RC_LIGHT0 + 1023;
  rcEnable(last);
  EXPECT_TRUE(rcIsEnabled(last));
  rcLightf(last, RC_SPOT_EXPONENT, 3);
  EXPECT_EQ(light(last, RC_SPOT_EXPONENT, 1), Values{3});
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_ENUM, rcEnable(last + 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcLightf(last + 1, RC_SPOT_EXPONENT, 1));
}

}  // namespace
}  // namespace rc::test
