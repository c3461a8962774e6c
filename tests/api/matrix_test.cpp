// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Matrices and their stacks. [spec 3.2]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using MatrixTest = ContextTest;

constexpr RCenum kModes[] = {RC_MODELVIEW, RC_PROJECTION, RC_TEXTURE};
constexpr RCenum kMatrices[] = {RC_MODELVIEW_MATRIX, RC_PROJECTION_MATRIX, RC_TEXTURE_MATRIX};
constexpr RCenum kDepths[] = {RC_MODELVIEW_STACK_DEPTH, RC_PROJECTION_STACK_DEPTH, RC_TEXTURE_STACK_DEPTH};
constexpr RCenum kLimits[] = {RC_MAX_MODELVIEW_STACK_DEPTH, RC_MAX_PROJECTION_STACK_DEPTH, RC_MAX_TEXTURE_STACK_DEPTH};

// 1, 2, ... 16.
template <class Value>
std::array<Value, 16> counting(Value one) {
  std::array<Value, 16> values;
  for (size_t i = 0; i < 16; ++i) values[i] = static_cast<Value>(i + 1) * one;
  return values;
}

TEST_F(MatrixTest, InitialState) {
  EXPECT_EQ(integer(RC_MATRIX_MODE), RC_MODELVIEW);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(floats(kMatrices[i], 16), kIdentity);
    EXPECT_EQ(integer(kDepths[i]), 1);
    EXPECT_EQ(integer(kLimits[i]), 32);
  }
}

TEST_F(MatrixTest, ModesSelectTheMatrix) {
  for (size_t i = 0; i < 3; ++i) {
    rcMatrixMode(kModes[i]);
    EXPECT_EQ(integer(RC_MATRIX_MODE), RCint(kModes[i]));
    rcTranslatef(float(i + 1), 0, 0);
  }
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(floats(kMatrices[i], 16)[12], float(i + 1));
}

TEST_F(MatrixTest, ModeErrors) {
  EXPECT_RAISES(RC_INVALID_ENUM, rcMatrixMode(kNoToken));
  EXPECT_RAISES(RC_INVALID_ENUM, rcMatrixMode(0));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMatrixMode(RC_MATRIX_PALETTE_OES));  // while the palette is off
}

TEST_F(MatrixTest, LoadTakesColumns) {
  const auto values = counting(1.0f);
  rcLoadMatrixf(values.data());
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), std::vector<float>(values.begin(), values.end()));
  const auto halves = counting(kFixedOne / 2);
  rcLoadMatrixx(halves.data());
  EXPECT_EQ(modelview()[0], 0.5f);
  EXPECT_EQ(modelview()[15], 8);
  rcLoadIdentity();
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), kIdentity);
}

TEST_F(MatrixTest, MultiplicationIsFromTheRight) {
  const float move[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
  rcScalef(2, 2, 2);
  rcMultMatrixf(move);
  EXPECT_EQ(modelview()[12], 6);
  EXPECT_EQ(modelview()[13], 8);
  EXPECT_EQ(modelview()[14], 10);
  RCfixed fixed[16];
  for (int i = 0; i < 16; ++i) fixed[i] = static_cast<RCfixed>(move[i]) * kFixedOne;
  rcMultMatrixx(fixed);
  EXPECT_EQ(modelview()[12], 12);
}

TEST_F(MatrixTest, NullMatricesAreHarmless) {
  rcTranslatef(1, 2, 3);
  const auto before = modelview();
  rcLoadMatrixf(nullptr);
  rcLoadMatrixx(nullptr);
  rcMultMatrixf(nullptr);
  rcMultMatrixx(nullptr);
  EXPECT_EQ(modelview(), before);
}

TEST_F(MatrixTest, TranslateAndScale) {
  rcTranslatef(1, 2, 3);
  rcScalef(4, 5, 6);
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), (std::vector<float>{4, 0, 0, 0, 0, 5, 0, 0, 0, 0, 6, 0, 1, 2, 3, 1}));
  rcLoadIdentity();
  rcTranslatex(kFixedOne, 2 * kFixedOne, -kFixedOne / 2);
  rcScalex(3 * kFixedOne, kFixedOne / 4, -kFixedOne);
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16),
            (std::vector<float>{3, 0, 0, 0, 0, 0.25f, 0, 0, 0, 0, -1, 0, 1, 2, -0.5f, 1}));
}

TEST_F(MatrixTest, RotationIsCounterClockwiseAboutAnyAxis) {
  rcRotatef(90, 0, 0, 5);  // x becomes y
  EXPECT_NEAR(modelview()[0], 0, 1e-6);
  EXPECT_NEAR(modelview()[1], 1, 1e-6);
  rcLoadIdentity();
  rcRotatex(90 * kFixedOne, kFixedOne, 0, 0);  // y becomes z
  EXPECT_NEAR(modelview()[6], 1, 1e-6);
  rcLoadIdentity();
  rcRotatef(120, 1, 1, 1);  // x becomes y, y becomes z, z becomes x
  EXPECT_NEAR(modelview()[1], 1, 1e-6);
  EXPECT_NEAR(modelview()[6], 1, 1e-6);
  EXPECT_NEAR(modelview()[8], 1, 1e-6);
}

TEST_F(MatrixTest, AZeroAxisTurnsNothing) {
  rcRotatef(45, 0, 0, 0);
  rcRotatex(45 * kFixedOne, 0, 0, 0);
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), kIdentity);
  EXPECT_CLEAN();
}

TEST_F(MatrixTest, StacksHold31CopiesAndOverflow) {
  for (size_t i = 0; i < 3; ++i) {
    rcMatrixMode(kModes[i]);
    for (int depth = 2; depth <= 32; ++depth) {
      rcTranslatef(1, 0, 0);
      rcPushMatrix();
      ASSERT_EQ(integer(kDepths[i]), depth);
    }
    EXPECT_CLEAN();
    EXPECT_RAISES(RC_STACK_OVERFLOW, rcPushMatrix());
    for (int depth = 31; depth >= 1; --depth) {
      rcLoadIdentity();
      rcPopMatrix();
      ASSERT_EQ(floats(kMatrices[i], 16)[12], float(depth));
    }
    EXPECT_CLEAN();
    EXPECT_RAISES(RC_STACK_UNDERFLOW, rcPopMatrix());
    EXPECT_EQ(integer(kDepths[i]), 1);
  }
}

// Matrices bring geometry to world space when it is submitted, not later.
TEST_F(MatrixTest, TheModelviewIsAppliedAtTheDrawCall) {
  pixelCamera();
  paint(1, 1, 1);
  rcTranslatef(30, 20, 0);
  drawQuad({-2, -2, 2, 2});
  rcLoadIdentity();
  rcFinish();
  EXPECT_EQ(pixel(30, 20), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(1, 1), kBlack);
}

TEST_F(MatrixTest, AZeroScaleDrawsNothingWithoutError) {
  pixelCamera();
  paint(1, 1, 1);
  rcScalef(0, 0, 0);
  drawQuad({0, 0, 64, 48});
  rcLoadIdentity();
  rcScalef(1, 0, 1);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), kBlack);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 0);
  EXPECT_CLEAN();
}

// A normal of a plane that is squeezed along it stays perpendicular: N.L stays 1 under the light at the eye.
TEST_F(MatrixTest, NormalsGoByTheInverseTranspose) {
  pixelCamera();
  const float black[] = {0, 0, 0}, white[] = {1, 1, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  const float half[] = {0.5f, 0.5f, 0.5f}, towards[] = {0, 0.6f, 0.8f, 0};
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, half);
  rcLightfv(RC_LIGHT0, RC_POSITION, towards);
  // The plane y + 2 z = 0 of normal (0, 1, 2); scaled by 4 along y it is y / 4 + 2 z = 0, normal (0, 1, 8).
  const float vertices[] = {-10, -2, 1, 10, -2, 1, 10, 2, -1, -10, 2, -1};
  const float normals[] = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2};
  rcTranslatef(32, 24, 0);
  rcScalef(1, 4, 1);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcEnableClientState(RC_NORMAL_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcNormalPointer(RC_FLOAT, 0, normals);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  const double cosine = (0.6 * 1 + 0.8 * 8) / std::sqrt(65.0);
  EXPECT_NEAR(pixel(32, 24)[0], std::floor(256 * 0.5 * cosine), 1);
}

TEST_F(MatrixTest, TheTextureMatrixMovesTextureCoordinates) {
  pixelCamera();
  rcBindTexture(RC_TEXTURE_2D, 1);
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadColumns({200, 0, 0}, {0, 0, 200});
  rcMatrixMode(RC_TEXTURE);
  rcTranslatef(0.5f, 0, 0);
  drawTexturedQuad({8, 8, 40, 40});
  rcFinish();
  EXPECT_EQ(pixel(16, 24), (Colour{0, 0, 200}));  // u = 0.25 + 0.5
  EXPECT_EQ(pixel(32, 24), (Colour{200, 0, 0}));
}

TEST_F(MatrixTest, MatricesPersistAcrossFramesAndStaticScenes) {
  rcTranslatef(1, 2, 3);
  const auto moved = modelview();
  rcStaticSceneBegin();
  drawQuad({0, 0, 1, 1});
  rcStaticSceneEnd();
  EXPECT_EQ(modelview(), moved);
  drawQuad({0, 0, 1, 1});
  rcFinish();
  context->endFrame();
  EXPECT_EQ(modelview(), moved);
}

TEST_F(MatrixTest, OldProfilesResetMatricesAfterAStaticScene) {
  for (const char *profile : {"1000", "mc"}) {
    useProfile(profile);
    rcPushMatrix();
    for (RCenum mode : kModes) {
      rcMatrixMode(mode);
      rcTranslatef(1, 2, 3);
    }
    rcStaticSceneBegin();
    drawQuad({0, 0, 1, 1});
    rcStaticSceneEnd();
    EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), kIdentity) << profile;
    EXPECT_EQ(floats(RC_TEXTURE_MATRIX, 16), kIdentity) << profile;
    EXPECT_NE(floats(RC_PROJECTION_MATRIX, 16), kIdentity) << profile;
    EXPECT_EQ(integer(RC_MATRIX_MODE), RC_TEXTURE) << profile;
    EXPECT_EQ(integer(RC_MODELVIEW_STACK_DEPTH), 2) << profile;
  }
}

TEST_F(MatrixTest, OldProfilesResetMatricesAfterAFrameWithDynamicGeometry) {
  useProfile("1000");
  rcTranslatef(1, 2, 3);
  const auto moved = modelview();
  rcFinish();
  EXPECT_EQ(modelview(), moved);  // nothing dynamic in that frame
  drawQuad({0, 0, 1, 1});
  rcFinish();
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), kIdentity);
}

// However often its picture is made: what is set after the first one is the next frame's.
TEST_F(MatrixTest, AFrameWithDynamicGeometryResetsMatricesOnceWhereTheProfileDoes) {
  useProfile("1000");
  pixelCamera();
  drawQuad({0, 0, 20, 20});
  rcTranslatef(3, 0, 0);
  rcFinish();
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16)[12], 0);
  rcTranslatef(5, 0, 0);
  rcEnable(RC_LIGHT0);
  rcFinish();
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16)[12], 5);
}

}  // namespace
}  // namespace rc::test
