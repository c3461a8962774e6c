// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcShadeModel: the last vertex of a primitive, or all of them. [OpenGL ES 1.1, 2.13]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class ShadeModelTest : public ContextTest {
 protected:
  static constexpr Colour kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
    rcShadeModel(RC_FLAT);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_COLOR_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, kStrip);
    rcColorPointer(4, RC_UNSIGNED_BYTE, 0, kColours);
  }
  void draw(RCenum mode, RCsizei count) {
    rcDrawArrays(mode, 0, count);
    trace();
  }
  // A strip of two triangles: below and above the line from (40, 0) to (0, 40).
  static constexpr float kStrip[] = {0, 0, 0, 40, 0, 0, 0, 40, 0, 40, 40, 0};
  static constexpr RCubyte kColours[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
};

TEST_F(ShadeModelTest, InitialStateAndErrors) {
  useProfile("guide");
  EXPECT_EQ(integer(RC_SHADE_MODEL), RC_SMOOTH);
  rcShadeModel(RC_FLAT);
  EXPECT_EQ(integer(RC_SHADE_MODEL), RC_FLAT);
  EXPECT_EQ(floats(RC_SHADE_MODEL, 1)[0], float(RC_FLAT));
  EXPECT_CLEAN();
  for (RCenum mode : {kNoToken, RCenum(RC_FASTEST), RCenum(0)}) EXPECT_RAISES(RC_INVALID_ENUM, rcShadeModel(mode));
}

TEST_F(ShadeModelTest, TrianglesShowTheirThirdVertex) {
  draw(RC_TRIANGLES, 3);
  for (const auto &[x, y] : {std::pair{2, 2}, {36, 1}, {2, 36}}) EXPECT_EQ(pixel(x, y), kBlue) << x;
}

TEST_F(ShadeModelTest, StripsShowEachTrianglesLast) {
  draw(RC_TRIANGLE_STRIP, 4);
  EXPECT_EQ(pixel(10, 10), kBlue);
  EXPECT_EQ(pixel(30, 30), kWhite);
}

TEST_F(ShadeModelTest, FansShowEachTrianglesLast) {
  static const float fan[] = {0, 0, 0, 40, 0, 0, 40, 40, 0, 0, 40, 0};
  rcVertexPointer(3, RC_FLOAT, 0, fan);
  draw(RC_TRIANGLE_FAN, 4);
  EXPECT_EQ(pixel(30, 10), kBlue);
  EXPECT_EQ(pixel(10, 30), kWhite);
}

TEST_F(ShadeModelTest, QuadsShowTheirFourthVertex) {
  static const float quad[] = {0, 0, 0, 40, 0, 0, 40, 40, 0, 0, 40, 0};
  rcVertexPointer(3, RC_FLOAT, 0, quad);
  draw(RC_QUADS, 4);
  EXPECT_EQ(pixel(30, 10), kWhite);
  EXPECT_EQ(pixel(10, 30), kWhite);
}

TEST_F(ShadeModelTest, IndicesCountToo) {
  const RCubyte indices[] = {1, 2, 0};
  rcDrawElements(RC_TRIANGLES, 3, RC_UNSIGNED_BYTE, indices);
  trace();
  EXPECT_EQ(pixel(10, 10), kRed);
}

TEST_F(ShadeModelTest, NormalsCountToo) {
  // At the first two vertices away from the light, at the last towards it.
  static const float normals[] = {1, 0, 0, 1, 0, 0, 0, 0, 1};
  rcDisableClientState(RC_COLOR_ARRAY);
  rcEnableClientState(RC_NORMAL_ARRAY);
  rcNormalPointer(RC_FLOAT, 0, normals);
  paintDiffuse(1, 1, 1);
  lightFrom(0, 0, 1, 0, 1);
  draw(RC_TRIANGLES, 3);
  EXPECT_EQ(pixel(1, 1), kWhite);
  rcShadeModel(RC_SMOOTH);
  draw(RC_TRIANGLES, 3);
  EXPECT_LT(pixel(1, 1)[0], 40);
}

TEST_F(ShadeModelTest, IsCapturedByTheDraw) {
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  rcShadeModel(RC_SMOOTH);
  trace();
  EXPECT_EQ(pixel(2, 2), kBlue);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  rcShadeModel(RC_FLAT);
  trace();
  EXPECT_GT(pixel(2, 2)[0], 220);
}

}  // namespace
}  // namespace rc::test
