// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Light model: light without a source. [OpenGL ES 1.1, 2.12.1]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class LightModelTest : public ContextTest {
 protected:
  // A wall of this ambient colour under `ambient` light and LIGHT0, which gives nothing.
  Colour shown(float ambient) {
    const float light[] = {ambient, ambient, ambient, 1};
    rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, light);
    pixelCamera();
    paint(1, 0.5f, 0.25f);
    drawQuad({-10, -10, 80, 60});
    trace();
    return pixel(30, 20);
  }
};

TEST_F(LightModelTest, InitialState) {
  EXPECT_EQ(floats(RC_LIGHT_MODEL_AMBIENT, 4), (Values{0, 0, 0, 1}));
  EXPECT_EQ(integer(RC_LIGHT_MODEL_TWO_SIDE), 0);
}

TEST_F(LightModelTest, IsKept) {
  const float colour[] = {0.2f, 3, -1, 0.5f};
  rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, colour);
  EXPECT_EQ(floats(RC_LIGHT_MODEL_AMBIENT, 4), (Values{0.2f, 1, 0, 0.5f}));
  RCint whole[4];
  rcGetIntegerv(RC_LIGHT_MODEL_AMBIENT, whole);
  EXPECT_EQ(whole[0], 51);
  EXPECT_EQ(whole[1], 255);
  const RCfixed fixed[] = {kFixedOne / 2, 0, kFixedOne, 0};
  rcLightModelxv(RC_LIGHT_MODEL_AMBIENT, fixed);
  EXPECT_EQ(floats(RC_LIGHT_MODEL_AMBIENT, 4), (Values{0.5f, 0, 1, 0}));
  RCfixed back[4];
  rcGetFixedv(RC_LIGHT_MODEL_AMBIENT, back);
  EXPECT_EQ(back[0], kFixedOne / 2);

  rcLightModelf(RC_LIGHT_MODEL_TWO_SIDE, 0.25f);
  EXPECT_EQ(integer(RC_LIGHT_MODEL_TWO_SIDE), 1);
  rcLightModelx(RC_LIGHT_MODEL_TWO_SIDE, 0);
  EXPECT_EQ(integer(RC_LIGHT_MODEL_TWO_SIDE), 0);
  rcLightModelx(RC_LIGHT_MODEL_TWO_SIDE, 1);
  RCboolean flag = 9;
  rcGetBooleanv(RC_LIGHT_MODEL_TWO_SIDE, &flag);
  EXPECT_EQ(flag, RC_TRUE);
  const float off[] = {0};
  rcLightModelfv(RC_LIGHT_MODEL_TWO_SIDE, off);
  EXPECT_EQ(integer(RC_LIGHT_MODEL_TWO_SIDE), 0);
  const RCfixed on[] = {kFixedOne};
  rcLightModelxv(RC_LIGHT_MODEL_TWO_SIDE, on);
  EXPECT_EQ(integer(RC_LIGHT_MODEL_TWO_SIDE), 1);
  EXPECT_CLEAN();
}

TEST_F(LightModelTest, Errors) {
  const float numbers[4] = {};
  const RCfixed fixed[4] = {};
  for (RCenum name : {kNoToken, RCenum(RC_AMBIENT), RCenum(RC_LIGHTING)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelf(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelx(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelfv(name, numbers));
    EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelxv(name, fixed));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelf(RC_LIGHT_MODEL_AMBIENT, 1));  // four values
  EXPECT_RAISES(RC_INVALID_ENUM, rcLightModelx(RC_LIGHT_MODEL_AMBIENT, 1));
  rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, nullptr);
  rcLightModelxv(RC_LIGHT_MODEL_AMBIENT, nullptr);
  EXPECT_CLEAN();
}

TEST_F(LightModelTest, GivesItsShareOfTheAmbientColour) {
  lightFrom(0, 0, 1, 0, 0);
  EXPECT_EQ(shown(0), kBlack);
  EXPECT_EQ(shown(0.5f), (Colour{128, 64, 32}));
  EXPECT_EQ(shown(1), (Colour{255, 128, 64}));
}

TEST_F(LightModelTest, AddsToTheLights) {
  lightFrom(0, 0, 1, 0, 0);
  const float quarter[] = {0.25f, 0.25f, 0.25f, 1};
  rcLightfv(RC_LIGHT0, RC_AMBIENT, quarter);
  EXPECT_EQ(shown(0.5f), (Colour{192, 96, 48}));
}

TEST_F(LightModelTest, WithoutLightingThereIsOnlyTheDefaultLight) { EXPECT_EQ(shown(0.5f), (Colour{255, 128, 64})); }

}  // namespace
}  // namespace rc::test
