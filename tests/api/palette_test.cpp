// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The matrix palette: a strip on two bones bends where it should; state and every error. [reference 4.7]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class PaletteTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
  }

  // Bone 0 stays, bone 1 moves by (dx, dy).
  void loadBones(float dx, float dy) {
    rcEnable(RC_MATRIX_PALETTE_OES);
    rcMatrixMode(RC_MATRIX_PALETTE_OES);
    rcCurrentPaletteMatrixOES(0);
    rcLoadIdentity();
    rcCurrentPaletteMatrixOES(1);
    const float move[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, dx, dy, 0, 1};
    rcLoadMatrixf(move);
    rcMatrixMode(RC_MODELVIEW);
  }

  // A strip 10 pixels high from x = 0 to 40 in two cells; its vertices follow bone 1 by 0, 1/2 and 1.
  void drawStrip() {
    static const float vertices[] = {0, 10, 0, 0, 20, 0, 20, 10, 0, 20, 20, 0, 40, 10, 0, 40, 20, 0};
    static const RCubyte bones[] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
    static const float weights[] = {1, 0, 1, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0, 1, 0, 1};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_MATRIX_INDEX_ARRAY_OES);
    rcEnableClientState(RC_WEIGHT_ARRAY_OES);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcMatrixIndexPointerOES(2, RC_UNSIGNED_BYTE, 0, bones);
    rcWeightPointerOES(2, RC_FLOAT, 0, weights);
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 6);
    rcFinish();
  }

  bool covered(int x, int y) const { return pixel(x, y) != kBlack; }
};

TEST_F(PaletteTest, InitialState) {
  EXPECT_EQ(integer(RC_MAX_PALETTE_MATRICES_OES), 128);
  EXPECT_EQ(integer(RC_MAX_VERTEX_UNITS_OES), 128);
  EXPECT_FALSE(rcIsEnabled(RC_MATRIX_PALETTE_OES));
  EXPECT_FALSE(rcIsEnabled(RC_MATRIX_INDEX_ARRAY_OES));
  EXPECT_FALSE(rcIsEnabled(RC_WEIGHT_ARRAY_OES));
  EXPECT_EQ(context->state.palette.matrices[5], Mat4(0)) << "zero until something is loaded";
  EXPECT_CLEAN();
}

TEST_F(PaletteTest, TheStripBendsBetweenTheBones) {
  loadBones(0, 20);
  drawStrip();
  EXPECT_CLEAN();
  // Its lower edge runs from (0, 10) over (20, 20) to (40, 30).
  EXPECT_TRUE(covered(2, 12));
  EXPECT_FALSE(covered(2, 9));
  EXPECT_TRUE(covered(18, 21));
  EXPECT_FALSE(covered(18, 17));
  EXPECT_TRUE(covered(38, 31));
  EXPECT_FALSE(covered(38, 27));
}

TEST_F(PaletteTest, TheModelviewActsFirst) {
  loadBones(0, 0);
  rcTranslatef(0, 10, 0);
  rcScalef(0.5f, 1, 1);
  drawStrip();
  EXPECT_TRUE(covered(18, 25));
  EXPECT_FALSE(covered(18, 15));
  EXPECT_FALSE(covered(22, 25)) << "scaled before it was skinned";
}

TEST_F(PaletteTest, WithoutTheCapNothingIsSkinned) {
  loadBones(0, 20);
  drawStrip();
  context->endFrame();
  rcDisable(RC_MATRIX_PALETTE_OES);
  rcDrawArrays(RC_TRIANGLE_STRIP, 0, 6);
  rcFinish();
  EXPECT_TRUE(covered(38, 12));
  EXPECT_FALSE(covered(38, 31));
}

TEST_F(PaletteTest, NormalsFollowTheBones) {
  // A bone that stretches y to twice its length halves the y of a normal: it goes by the inverse transpose.
  static const float light[] = {0, 0, 1, 0}, none[] = {0, 0, 0}, full[] = {1, 1, 1};
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, light);
  rcLightfv(RC_LIGHT0, RC_AMBIENT, none);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, full);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, full);
  static const float vertices[] = {0, 0, 0, 20, 0, 0, 20, 20, 0, 0, 20, 0};
  static const float tilted[] = {0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f};
  static const RCubyte bones[4] = {};
  static const float weights[] = {1, 1, 1, 1};
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  const float stretch[] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  rcLoadMatrixf(stretch);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcEnableClientState(RC_NORMAL_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcNormalPointer(RC_FLOAT, 0, tilted);
  rcMatrixIndexPointerOES(1, RC_UNSIGNED_BYTE, 0, bones);
  rcWeightPointerOES(1, RC_FLOAT, 0, weights);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  const float cosine = 0.6f / std::sqrt(0.6f * 0.6f + 0.4f * 0.4f);
  EXPECT_NEAR(pixel(10, 30)[0], int(256 * cosine), 1);
  EXPECT_CLEAN();
}

TEST_F(PaletteTest, IndicesOutOfRangeAddNothing) {
  loadBones(0, 0);
  static const float vertices[] = {0, 0, 0, 20, 0, 0, 0, 20, 0}, weights[] = {1, 9, 1, 9, 1, 9};
  static const RCuint bones[] = {0, 128, 0, 0xffffffff, 0, 500};
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcMatrixIndexPointerOES(2, RC_UNSIGNED_INT, 0, bones);
  rcWeightPointerOES(2, RC_FLOAT, 0, weights);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  rcFinish();
  EXPECT_TRUE(covered(5, 5));
  EXPECT_CLEAN();
}

TEST_F(PaletteTest, MovesPushesAndPopsDoNothingInPaletteMode) {
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  EXPECT_EQ(integer(RC_MATRIX_MODE), RC_MATRIX_PALETTE_OES);
  rcLoadIdentity();
  rcTranslatef(1, 2, 3);
  rcRotatef(45, 0, 0, 1);
  rcScalef(2, 2, 2);
  rcPushMatrix();
  rcPopMatrix();
  rcPopMatrix();
  EXPECT_EQ(context->state.palette.matrices[0], Mat4(1));
  rcMultMatrixf(std::vector<float>{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}.data());
  EXPECT_EQ(context->state.palette.matrices[0][0][0], 2);
  EXPECT_CLEAN();
}

TEST_F(PaletteTest, LoadsTheModelviewMatrix) {
  rcTranslatef(1, 2, 3);
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcCurrentPaletteMatrixOES(7);
  rcLoadPaletteFromModelViewMatrixOES();
  EXPECT_EQ(context->state.palette.matrices[7][3], Vec4(1, 2, 3, 1));
  rcEnable(RC_MATRIX_PALETTE_OES);  // either way the index begins anew
  EXPECT_EQ(context->state.palette.current, 0u);
  EXPECT_CLEAN();
}

TEST_F(PaletteTest, Errors) {
  const char memory[4] = {};
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMatrixMode(RC_MATRIX_PALETTE_OES));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcCurrentPaletteMatrixOES(0));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcLoadPaletteFromModelViewMatrixOES());
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMatrixIndexPointerOES(1, RC_UNSIGNED_BYTE, 0, memory));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcWeightPointerOES(1, RC_FLOAT, 0, memory));
  rcEnable(RC_MATRIX_PALETTE_OES);
  EXPECT_RAISES(RC_INVALID_VALUE, rcCurrentPaletteMatrixOES(128));
  for (RCint size : {0, -1, 129}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcMatrixIndexPointerOES(size, RC_UNSIGNED_BYTE, 0, memory));
    EXPECT_RAISES(RC_INVALID_VALUE, rcWeightPointerOES(size, RC_FLOAT, 0, memory));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcMatrixIndexPointerOES(1, RC_UNSIGNED_BYTE, -1, memory));
  EXPECT_RAISES(RC_INVALID_VALUE, rcWeightPointerOES(1, RC_FLOAT, -1, memory));
  EXPECT_RAISES(RC_INVALID_ENUM, rcMatrixIndexPointerOES(1, RC_FLOAT, 0, memory));
  EXPECT_RAISES(RC_INVALID_ENUM, rcWeightPointerOES(1, RC_UNSIGNED_BYTE, 0, memory));
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  rcDisable(RC_MATRIX_PALETTE_OES);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcLoadIdentity());
  EXPECT_RAISES(RC_INVALID_OPERATION, rcLoadMatrixf(kIdentity.data()));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMultMatrixf(kIdentity.data()));
}

}  // namespace
}  // namespace rc::test
