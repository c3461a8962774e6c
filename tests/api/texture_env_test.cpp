// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Texture environment and texture units: state, errors, and what each mode shows. [OpenGL ES 1.1, 3.7.12]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class TextureEnvTest : public ContextTest {
 protected:
  void mode(RCenum value) { rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, RCint(value)); }
  // Only ambient light of full strength: a surface shows what became of its ambient colour.
  void ambientOnly() {
    pixelCamera();
    lightFrom(0, 0, 1, 0, 0);
    const float white[] = {1, 1, 1, 1};
    rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, white);
    paint(0.5f, 0.25f, 0);
    rcEnable(RC_TEXTURE_2D);
  }
  void expectShown(float red, float green, float blue) {
    drawTexturedQuad({-10, -10, 80, 60});
    trace();
    const Colour shown = pixel(30, 20);
    EXPECT_NEAR(shown[0], 256 * red, 1);
    EXPECT_NEAR(shown[1], 256 * green, 1);
    EXPECT_NEAR(shown[2], 256 * blue, 1);
  }
};

// Names of one token each, with their initial value and another one.
constexpr struct {
  RCenum name, initial, other;
} kTokens[] = {{RC_TEXTURE_ENV_MODE, RC_REPLACE, RC_DECAL},
               {RC_COMBINE_RGB, RC_MODULATE, RC_DOT3_RGBA},
               {RC_COMBINE_ALPHA, RC_MODULATE, RC_SUBTRACT},
               {RC_SRC0_RGB, RC_TEXTURE, RC_PRIMARY_COLOR},
               {RC_SRC1_RGB, RC_PREVIOUS, RC_CONSTANT},
               {RC_SRC2_RGB, RC_CONSTANT, RC_TEXTURE},
               {RC_SRC0_ALPHA, RC_TEXTURE, RC_PREVIOUS},
               {RC_SRC1_ALPHA, RC_PREVIOUS, RC_TEXTURE},
               {RC_SRC2_ALPHA, RC_CONSTANT, RC_PRIMARY_COLOR},
               {RC_OPERAND0_RGB, RC_SRC_COLOR, RC_ONE_MINUS_SRC_COLOR},
               {RC_OPERAND1_RGB, RC_SRC_COLOR, RC_ONE_MINUS_SRC_ALPHA},
               {RC_OPERAND2_RGB, RC_SRC_ALPHA, RC_SRC_COLOR},
               {RC_OPERAND0_ALPHA, RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA},
               {RC_OPERAND1_ALPHA, RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA},
               {RC_OPERAND2_ALPHA, RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA}};

TEST_F(TextureEnvTest, InitialState) {
  for (const auto &row : kTokens) EXPECT_EQ(texEnv(row.name, 1), Values{float(row.initial)}) << row.name;
  EXPECT_EQ(texEnv(RC_TEXTURE_ENV_COLOR, 4), (Values{0, 0, 0, 0}));
  EXPECT_EQ(texEnv(RC_RGB_SCALE, 1), Values{1});
  EXPECT_EQ(texEnv(RC_ALPHA_SCALE, 1), Values{1});
  EXPECT_EQ(texEnv(RC_COORD_REPLACE_OES, 1, RC_POINT_SPRITE_OES), Values{0});
  RCint whole[4] = {7, 7, 7, 7};
  rcGetTexEnviv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, whole);
  EXPECT_EQ(whole[0], 0);
}

TEST_F(TextureEnvTest, TokensAreKeptInEveryType) {
  for (const auto &[name, initial, other] : kTokens) {
    for (int way = 0; way < 6; ++way) {
      rcTexEnvi(RC_TEXTURE_ENV, name, RCint(initial));
      const RCint whole[] = {RCint(other)};
      const RCfixed fixed[] = {RCfixed(other)};  // never scaled
      const float real[] = {float(other)};
      if (way == 0) rcTexEnvi(RC_TEXTURE_ENV, name, whole[0]);
      if (way == 1) rcTexEnvf(RC_TEXTURE_ENV, name, real[0]);
      if (way == 2) rcTexEnvx(RC_TEXTURE_ENV, name, fixed[0]);
      if (way == 3) rcTexEnviv(RC_TEXTURE_ENV, name, whole);
      if (way == 4) rcTexEnvfv(RC_TEXTURE_ENV, name, real);
      if (way == 5) rcTexEnvxv(RC_TEXTURE_ENV, name, fixed);
      EXPECT_CLEAN();
      EXPECT_EQ(texEnv(name, 1), Values{float(other)}) << name << ' ' << way;
      RCint wholeBack[4] = {};
      rcGetTexEnviv(RC_TEXTURE_ENV, name, wholeBack);
      EXPECT_EQ(wholeBack[0], RCint(other));
      RCfixed fixedBack[4] = {};
      rcGetTexEnvxv(RC_TEXTURE_ENV, name, fixedBack);
      EXPECT_EQ(fixedBack[0], RCfixed(other));
    }
  }
}

TEST_F(TextureEnvTest, NumbersAndColours) {
  for (RCenum name : {RC_RGB_SCALE, RC_ALPHA_SCALE}) {
    for (int scale : {2, 4, 1}) {
      rcTexEnvf(RC_TEXTURE_ENV, RCenum(name), float(scale));
      EXPECT_EQ(texEnv(RCenum(name), 1), Values{float(scale)});
      rcTexEnvx(RC_TEXTURE_ENV, RCenum(name), scale * kFixedOne);
      RCfixed back = 0;
      rcGetTexEnvxv(RC_TEXTURE_ENV, RCenum(name), &back);
      EXPECT_EQ(back, scale * kFixedOne);
    }
  }
  const float colour[] = {0.25f, 2, -1, 0.5f};
  rcTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, colour);
  EXPECT_EQ(texEnv(RC_TEXTURE_ENV_COLOR, 4), (Values{0.25f, 1, 0, 0.5f}));
  const RCfixed fixed[] = {kFixedOne / 2, 0, kFixedOne, 0};
  rcTexEnvxv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, fixed);
  EXPECT_EQ(texEnv(RC_TEXTURE_ENV_COLOR, 4), (Values{0.5f, 0, 1, 0}));
  constexpr RCint kMost = std::numeric_limits<RCint>::max();
  const RCint whole[] = {kMost, 0, kMost, 0};  // integers span the range of their type
  rcTexEnviv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, whole);
  EXPECT_FLOAT_EQ(texEnv(RC_TEXTURE_ENV_COLOR, 4)[0], 1);
  EXPECT_NEAR(texEnv(RC_TEXTURE_ENV_COLOR, 4)[1], 0, 1e-6);
  RCint back[4];
  rcGetTexEnviv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, back);
  EXPECT_TRUE(std::equal(whole, whole + 4, back));
  rcTexEnvi(RC_POINT_SPRITE_OES, RC_COORD_REPLACE_OES, RC_TRUE);
  EXPECT_EQ(texEnv(RC_COORD_REPLACE_OES, 1, RC_POINT_SPRITE_OES), Values{1});
  EXPECT_CLEAN();
}

TEST_F(TextureEnvTest, NameErrors) {
  float real[4] = {};
  RCint whole[4] = {};
  const auto all = [&](RCenum target, RCenum name) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvf(target, name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvi(target, name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvx(target, name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvfv(target, name, real));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnviv(target, name, whole));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvxv(target, name, whole));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexEnvfv(target, name, real));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexEnviv(target, name, whole));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexEnvxv(target, name, whole));
  };
  all(kNoToken, RC_TEXTURE_ENV_MODE);
  all(RC_TEXTURE_2D, RC_TEXTURE_ENV_MODE);
  all(RC_TEXTURE_ENV, kNoToken);
  all(RC_TEXTURE_ENV, RC_COORD_REPLACE_OES);
  all(RC_POINT_SPRITE_OES, RC_TEXTURE_ENV_MODE);
  rcTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  rcTexEnviv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  rcTexEnvxv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  rcGetTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  rcGetTexEnviv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  rcGetTexEnvxv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, nullptr);
  EXPECT_CLEAN();
}

TEST_F(TextureEnvTest, ValueErrors) {
  for (const auto &row : kTokens) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvi(RC_TEXTURE_ENV, row.name, RC_NEAREST));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvf(RC_TEXTURE_ENV, row.name, 0.5f));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvf(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, 1));  // four values
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvi(RC_TEXTURE_ENV, RC_COMBINE_ALPHA, RC_DOT3_RGB));
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexEnvi(RC_TEXTURE_ENV, RC_OPERAND0_ALPHA, RC_SRC_COLOR));
  for (int scale : {0, 3, 5, -1}) {
    const float real[] = {float(scale)};
    const RCfixed fixed[] = {scale * kFixedOne};
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnvf(RC_TEXTURE_ENV, RC_RGB_SCALE, real[0]));
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnvi(RC_TEXTURE_ENV, RC_RGB_SCALE, scale));
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnvx(RC_TEXTURE_ENV, RC_ALPHA_SCALE, fixed[0]));
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnvfv(RC_TEXTURE_ENV, RC_ALPHA_SCALE, real));
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnviv(RC_TEXTURE_ENV, RC_RGB_SCALE, &scale));
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexEnvxv(RC_TEXTURE_ENV, RC_RGB_SCALE, fixed));
  }
}

TEST_F(TextureEnvTest, ThereIsOneUnit) {
  EXPECT_EQ(integer(RC_MAX_TEXTURE_UNITS), 1);
  rcActiveTexture(RC_TEXTURE0);
  rcClientActiveTexture(RC_TEXTURE0);
  EXPECT_CLEAN();
  for (RCenum unit : {RCenum(RC_TEXTURE0 + 1), RCenum(RC_TEXTURE0 - 1), RCenum(0), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcActiveTexture(unit));
    EXPECT_RAISES(RC_INVALID_ENUM, rcClientActiveTexture(unit));
  }
}

TEST_F(TextureEnvTest, WhatEachModeShows) {
  ambientOnly();
  loadRgba(204, 102, 51, 51);  // 0.8, 0.4, 0.2; opaque, since 16 is
  const float environment[] = {0, 1, 0.5f, 1};
  rcTexEnvfv(RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, environment);
  expectShown(0.8f, 0.4f, 0.2f);
  mode(RC_MODULATE);
  expectShown(0.4f, 0.1f, 0);
  mode(RC_DECAL);  // a fifth of the texel
  expectShown(0.56f, 0.28f, 0.04f);
  mode(RC_BLEND);
  expectShown(0.5f * 0.2f, 0.25f * 0.6f + 0.4f, 0.5f * 0.2f);
  mode(RC_ADD);
  expectShown(1 - 1 / 256.0f, 0.65f, 0.2f);
  mode(RC_COMBINE);
  rcTexEnvi(RC_TEXTURE_ENV, RC_COMBINE_RGB, RC_ADD);  // kept
  expectShown(0.4f, 0.1f, 0);
}

TEST_F(TextureEnvTest, DiffuseIsChangedToo) {
  pixelCamera();
  lightFrom(0, 0, 1, 0, 1);
  paintDiffuse(0.5f, 0.25f, 1);
  rcEnable(RC_TEXTURE_2D);
  loadSolid({204, 102, 51});
  expectShown(0.8f, 0.4f, 0.2f);
  mode(RC_MODULATE);
  expectShown(0.4f, 0.1f, 0.2f);
}

TEST_F(TextureEnvTest, ColourArraysMultiplyWhatTheModeMakes) {
  ambientOnly();
  loadSolid({204, 102, 51});
  mode(RC_MODULATE);
  static const RCubyte half[] = {128, 64, 255, 255, 128, 64, 255, 255, 128, 64, 255, 255, 128, 64, 255, 255};
  rcEnableClientState(RC_COLOR_ARRAY);
  rcColorPointer(4, RC_UNSIGNED_BYTE, 0, half);
  expectShown(0.4f * 128 / 255, 0.1f * 64 / 255, 0);
}

TEST_F(TextureEnvTest, BelongsToTheBoundMaterial) {
  ambientOnly();
  loadSolid({204, 102, 51});
  rcBindMaterial(1);
  mode(RC_MODULATE);
  rcBindMaterial(2);  // a copy
  EXPECT_EQ(texEnv(RC_TEXTURE_ENV_MODE, 1), Values{RC_MODULATE});
  mode(RC_REPLACE);
  rcBindMaterial(1);
  EXPECT_EQ(texEnv(RC_TEXTURE_ENV_MODE, 1), Values{RC_MODULATE});
  expectShown(0.4f, 0.1f, 0);
  rcBindMaterial(2);
  expectShown(0.8f, 0.4f, 0.2f);
}

}  // namespace
}  // namespace rc::test
