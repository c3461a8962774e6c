// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcAlphaFunc: what is not opaque enough is not there for any ray. [OpenGL ES 1.1, 4.1.4]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class AlphaTestTest : public ContextTest {
 protected:
  static constexpr Rect kAll{-300, -300, 400, 400};
  static constexpr float kLevel = 128 / 255.0f;

  // Opacity is a texel's alpha / 255.
  void textured(int alpha) {
    rcEnable(RC_TEXTURE_2D);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 255);
    loadRgba(200, 200, 200, alpha);
  }
};

constexpr struct {
  RCenum func;
  bool less, equal, greater;
} kFunctions[] = {{RC_NEVER, false, false, false}, {RC_LESS, true, false, false},    {RC_EQUAL, false, true, false},
                  {RC_LEQUAL, true, true, false},  {RC_GREATER, false, false, true}, {RC_NOTEQUAL, true, false, true},
                  {RC_GEQUAL, false, true, true},  {RC_ALWAYS, true, true, true}};

TEST_F(AlphaTestTest, InitialState) {
  EXPECT_FALSE(rcIsEnabled(RC_ALPHA_TEST));
  EXPECT_EQ(integer(RC_ALPHA_TEST_FUNC), RC_ALWAYS);
  EXPECT_EQ(floats(RC_ALPHA_TEST_REF, 1)[0], 0);
  EXPECT_EQ(integer(RC_ALPHA_TEST_REF), 0);
}

TEST_F(AlphaTestTest, IsKept) {
  for (const auto &row : kFunctions) {
    rcAlphaFunc(row.func, 0.25f);
    EXPECT_EQ(integer(RC_ALPHA_TEST_FUNC), RCint(row.func));
    EXPECT_EQ(floats(RC_ALPHA_TEST_REF, 1)[0], 0.25f);
    rcAlphaFuncx(row.func, kFixedOne / 2);
    RCfixed reference = 0;
    rcGetFixedv(RC_ALPHA_TEST_REF, &reference);
    EXPECT_EQ(reference, kFixedOne / 2);
  }
  rcAlphaFunc(RC_LESS, 7);
  EXPECT_EQ(floats(RC_ALPHA_TEST_REF, 1)[0], 1);
  EXPECT_EQ(integer(RC_ALPHA_TEST_REF), std::numeric_limits<RCint>::max());
  rcAlphaFuncx(RC_LESS, -kFixedOne);
  EXPECT_EQ(floats(RC_ALPHA_TEST_REF, 1)[0], 0);
  EXPECT_CLEAN();
}

TEST_F(AlphaTestTest, Errors) {
  for (RCenum func : {kNoToken, RCenum(RC_NEVER - 1), RCenum(RC_ALWAYS + 1)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcAlphaFunc(func, 0.5f));
    EXPECT_RAISES(RC_INVALID_ENUM, rcAlphaFuncx(func, kFixedOne / 2));
  }
}

TEST_F(AlphaTestTest, EveryComparison) {
  pixelCamera();
  rcEnable(RC_USE_TEXTURE_ONLY);
  rcEnable(RC_ALPHA_TEST);
  for (const auto &row : kFunctions) {
    rcAlphaFunc(row.func, kLevel);
    for (const auto &[alpha, passes] : {std::pair{127, row.less}, {128, row.equal}, {129, row.greater}}) {
      textured(alpha);
      drawTexturedQuad(kAll);
      trace();
      EXPECT_NEAR(pixel(32, 24)[0], passes ? 200 * alpha / 255 : 0, 1) << row.func << " alpha " << alpha;
    }
  }
}

TEST_F(AlphaTestTest, SurfacesWithoutTextureAreOpaque) {
  pixelCamera();
  paint(1, 1, 1);
  rcEnable(RC_ALPHA_TEST);
  for (const auto &[func, there] : {std::pair<RCenum, bool>{RC_LESS, false}, {RC_GEQUAL, true}, {RC_NEVER, false}}) {
    rcAlphaFunc(func, 1);
    drawQuad(kAll);
    trace();
    EXPECT_EQ(pixel(32, 24)[0], there ? 255 : 0) << func;
  }
}

TEST_F(AlphaTestTest, IsCapturedByTheDraw) {
  pixelCamera();
  paint(1, 1, 1);
  rcAlphaFunc(RC_NEVER, 0);
  drawQuad({0, 0, 20, 48});
  rcEnable(RC_ALPHA_TEST);
  drawQuad({20, 0, 40, 48});
  rcAlphaFunc(RC_ALWAYS, 0);
  drawQuad({40, 0, 64, 48});
  rcAlphaFunc(RC_NEVER, 0);
  trace();
  EXPECT_EQ(pixel(10, 24)[0], 255);
  EXPECT_EQ(pixel(30, 24)[0], 0);
  EXPECT_EQ(pixel(50, 24)[0], 255);
}

// As in CullingTest: the occluder darkens the wall to its left.
TEST_F(AlphaTestTest, WhatFailsCastsNoShadow) {
  pixelCamera();
  lightFrom(1, 0, 1, 0, 1);
  const auto shadow = [&](int alpha) {
    rcDisable(RC_ALPHA_TEST);
    rcBindMaterial(1);
    paintDiffuse(1, 1, 1);
    drawQuad(kAll);
    rcBindMaterial(2);
    textured(alpha);
    rcEnable(RC_ALPHA_TEST);
    rcAlphaFunc(RC_GEQUAL, kLevel);
    drawTexturedQuad({30, -50, 60, 100}, 1, 1, 10);
    trace();
    return pixel(24, 24)[0];
  };
  EXPECT_NEAR(shadow(127), 256 * std::sqrt(0.5), 1);
  EXPECT_EQ(shadow(128), 0) << "what is there blocks wholly";
  rcEnable(RC_USE_TEXTURE_ALPHA_SHADOW);
  EXPECT_NEAR(shadow(127), 256 * std::sqrt(0.5), 1);
  EXPECT_NEAR(shadow(153), 256 * std::sqrt(0.5) * 0.4, 1);
}

}  // namespace
}  // namespace rc::test
