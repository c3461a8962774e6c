// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What vertices have without an array, and the array of points' sizes. [OpenGL ES 1.1, 2.7, 2.8]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;

class ArrayPointerTest : public ContextTest {
 protected:
  // What a quad without texture coordinates of its own shows.
  Colour shown() {
    drawQuad({-10, -10, 80, 60});
    trace();
    return pixel(30, 20);
  }
};

TEST_F(ArrayPointerTest, CurrentValues) {
  EXPECT_EQ(floats(RC_CURRENT_TEXTURE_COORDS, 4), (Values{0, 0, 0, 1}));
  EXPECT_EQ(floats(RC_CURRENT_NORMAL, 3), (Values{0, 0, 1}));
  rcMultiTexCoord4f(RC_TEXTURE0, 0.5f, -2, 3, 4);
  EXPECT_EQ(floats(RC_CURRENT_TEXTURE_COORDS, 4), (Values{0.5f, -2, 3, 4}));
  rcMultiTexCoord4x(RC_TEXTURE0, kFixedOne / 4, 0, -kFixedOne, kFixedOne);
  RCfixed fixed[4];
  rcGetFixedv(RC_CURRENT_TEXTURE_COORDS, fixed);
  EXPECT_EQ(fixed[0], kFixedOne / 4);
  EXPECT_EQ(fixed[2], -kFixedOne);
  rcNormal3f(0, 2, -0.5f);
  EXPECT_EQ(floats(RC_CURRENT_NORMAL, 3), (Values{0, 2, -0.5f})) << "as given";
  rcNormal3x(kFixedOne, 0, kFixedOne / 2);
  EXPECT_EQ(floats(RC_CURRENT_NORMAL, 3), (Values{1, 0, 0.5f}));
  EXPECT_CLEAN();
}

TEST_F(ArrayPointerTest, UnitErrors) {
  for (RCenum unit : {RCenum(RC_TEXTURE0 + 1), RCenum(RC_TEXTURE0 - 1), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcMultiTexCoord4f(unit, 1, 1, 1, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMultiTexCoord4x(unit, 1, 1, 1, 1));
  }
}

TEST_F(ArrayPointerTest, TheCurrentCoordinateIsThatOfVerticesWithoutAnArray) {
  pixelCamera();
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadColumns(kRed, kBlue);
  rcMultiTexCoord4f(RC_TEXTURE0, 0.25f, 0.5f, 0, 1);
  EXPECT_EQ(shown(), kRed);
  rcMultiTexCoord4f(RC_TEXTURE0, 0.75f, 0.5f, 0, 1);
  EXPECT_EQ(shown(), kBlue);
  rcMultiTexCoord4f(RC_TEXTURE0, 0.75f, 0.5f, 0, 3);  // divided by q
  EXPECT_EQ(shown(), kRed);
  rcMatrixMode(RC_TEXTURE);
  rcTranslatef(1.5f, 0, 0);  // times q, then divided
  EXPECT_EQ(shown(), kBlue);
  rcLoadIdentity();
  rcMultiTexCoord4x(RC_TEXTURE0, kFixedOne * 3 / 4, 0, 0, kFixedOne);
  EXPECT_EQ(shown(), kBlue);
  drawTexturedQuad({-10, -10, 80, 60}, 0.4f);  // an array counts more
  trace();
  EXPECT_EQ(pixel(30, 20), kRed);
}

TEST_F(ArrayPointerTest, SizesOfPointsAreKept) {
  EXPECT_FALSE(rcIsEnabled(RC_POINT_SIZE_ARRAY_OES));
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_TYPE_OES), RC_FLOAT);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_STRIDE_OES), 4);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_BUFFER_BINDING_OES), 0);
  RCfixed sizes[8] = {};
  rcEnableClientState(RC_POINT_SIZE_ARRAY_OES);
  rcPointSizePointerOES(RC_FIXED, 8, sizes);
  EXPECT_CLEAN();
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_OES), 1);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_TYPE_OES), RC_FIXED);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_STRIDE_OES), 8);
  RCvoid *pointer = nullptr;
  rcGetPointerv(RC_POINT_SIZE_ARRAY_POINTER_OES, &pointer);
  EXPECT_EQ(pointer, sizes);
  rcBindBuffer(RC_ARRAY_BUFFER, 5);
  rcBufferData(RC_ARRAY_BUFFER, sizeof sizes, sizes, RC_STATIC_DRAW);
  rcPointSizePointerOES(RC_FLOAT, 0, nullptr);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_BUFFER_BINDING_OES), 5);
  EXPECT_EQ(integer(RC_POINT_SIZE_ARRAY_STRIDE_OES), 4) << "packed";
  EXPECT_CLEAN();
}

TEST_F(ArrayPointerTest, SizesOfPointsErrors) {
  const float sizes[4] = {};
  for (RCenum type : {RCenum(RC_BYTE), RCenum(RC_SHORT), RCenum(RC_UNSIGNED_INT), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcPointSizePointerOES(type, 0, sizes));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointSizePointerOES(RC_FLOAT, -1, sizes));
}

// An array of sizes that is on, without a pointer, stops no triangle.
TEST_F(ArrayPointerTest, SizesOfPointsHaveNoEffect) {
  pixelCamera();
  paint(1, 1, 1);
  rcEnableClientState(RC_POINT_SIZE_ARRAY_OES);
  EXPECT_EQ(shown(), (Colour{255, 255, 255}));
}

}  // namespace
}  // namespace rc::test
