// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Draw calls: modes, triangles that are left out, what of the state a draw captures. [spec 3.6]
#include "api/geometry_fixture.h"

namespace rc::test {
namespace {

class DrawTest : public GeometryTest {
 protected:
  // White over the whole picture, under half a light: 128.
  void drawLitWall() {
    const float black[] = {0, 0, 0}, white[] = {1, 1, 1}, half[] = {0.5f, 0.5f, 0.5f};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, half);
    drawQuad({0, 0, 64, 48});
  }
};

TEST_F(DrawTest, DrawErrors) {
  useVertices(kSquare);
  const RCubyte indices[] = {0, 1, 2};
  for (RCenum mode : {RCenum(RC_POINTS), RCenum(RC_LINES), RCenum(RC_LINE_LOOP), RCenum(RC_LINE_STRIP), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcDrawArrays(mode, 0, 3));
    EXPECT_RAISES(RC_INVALID_ENUM, rcDrawElements(mode, 3, RC_UNSIGNED_BYTE, indices));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcDrawArrays(RC_TRIANGLES, 0, -1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcDrawArrays(RC_TRIANGLES, -1, 3));
  EXPECT_RAISES(RC_INVALID_VALUE, rcDrawElements(RC_TRIANGLES, -1, RC_UNSIGNED_BYTE, indices));
  EXPECT_RAISES(RC_INVALID_ENUM, rcDrawElements(RC_TRIANGLES, 3, RC_FLOAT, indices));
  EXPECT_RAISES(RC_INVALID_ENUM, rcDrawElements(RC_TRIANGLES, 3, kNoToken, indices));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcDrawElements(RC_TRIANGLES, 3, RC_UNSIGNED_BYTE, nullptr));
  rcDrawArrays(RC_TRIANGLES, 0, 0);
  rcDrawElements(RC_TRIANGLES, 0, RC_UNSIGNED_BYTE, indices);
  EXPECT_CLEAN();
  EXPECT_EQ(triangles(), 0);
}

TEST_F(DrawTest, ModesAndIncompletePrimitives) {
  const std::vector<float> strip{0, 0, 0, 10, 0, 0, 0, 10, 0, 10, 10, 0, 0, 20, 0, 10, 20, 0, 0, 30, 0};  // 7 vertices
  useVertices(strip.data());
  const struct {
    RCenum mode;
    int counts[8];  // of triangles from 0 ... 7 vertices
  } cases[] = {{RC_TRIANGLES, {0, 0, 0, 1, 1, 1, 2, 2}},
               {RC_TRIANGLE_STRIP, {0, 0, 0, 1, 2, 3, 4, 5}},
               {RC_QUADS, {0, 0, 0, 0, 2, 2, 2, 2}}};
  for (const auto &[mode, counts] : cases) {
    for (int count = 0; count <= 7; ++count) {
      rcDrawArrays(mode, 0, count);
      rcFinish();
      const RCint skipped = integer(RC_FRAME_TRIANGLES_SKIPPED);  // a zigzag has flat quads
      EXPECT_EQ(integer(RC_FRAME_TRIANGLES) + skipped, counts[count]) << mode << " of " << count;
      context->endFrame();
    }
  }
  const float fan[] = {20, 20, 0, 30, 20, 0, 20, 30, 0, 10, 20, 0, 20, 10, 0};
  useVertices(fan);
  for (int count = 0; count <= 5; ++count) {
    rcDrawArrays(RC_TRIANGLE_FAN, 0, count);
    EXPECT_EQ(triangles(), std::max(count - 2, 0));
    context->endFrame();
  }
}

TEST_F(DrawTest, EveryModeShowsASquare) {
  const float strip[] = {10, 10, 0, 30, 10, 0, 10, 30, 0, 30, 30, 0};
  const float pair[] = {10, 10, 0, 30, 10, 0, 30, 30, 0, 10, 10, 0, 30, 30, 0, 10, 30, 0};
  const struct {
    const float *vertices;
    RCenum mode;
    RCsizei count;
  } cases[] = {
      {kSquare, RC_QUADS, 4}, {kSquare, RC_TRIANGLE_FAN, 4}, {strip, RC_TRIANGLE_STRIP, 4}, {pair, RC_TRIANGLES, 6}};
  for (const auto &[vertices, mode, count] : cases) {
    useVertices(vertices);
    rcDrawArrays(mode, 0, count);
    rcFinish();
    for (const auto &[x, y] : {std::pair{12, 14}, {28, 24}, {14, 28}, {28, 12}}) EXPECT_EQ(pixel(x, y), kWhite) << mode;
    EXPECT_EQ(pixel(35, 20), kBlack) << mode;
  }
}

// Front is where the vertices go counter-clockwise: there a dense material lets rays in, and all that meet its
// back at an angle are totally reflected. All triangles of a strip face alike.
TEST_F(DrawTest, AStripFacesOneWay) {
  rcClearColor(1, 1, 1, 0);
  const float front[] = {0, 0, 0, 64, 0, 0, 0, 48, 0, 64, 48, 0};
  const float back[] = {64, 0, 0, 0, 0, 0, 64, 48, 0, 0, 48, 0};
  for (const float *strip : {front, back}) {
    paint(0, 0, 0);
    rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 1);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, 100);
    useVertices(strip);
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 4);
    rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 0);
    drawQuad({-300, -300, 300, 300}, 100);  // black, behind the viewer: what reflected rays meet
    rcFinish();
    const Colour expected = strip == front ? kWhite : kBlack;
    EXPECT_EQ(pixel(5, 5), expected);
    EXPECT_EQ(pixel(60, 44), expected);
  }
}

TEST_F(DrawTest, BadTrianglesAreSkippedAndCounted) {
  std::vector<float> vertices;
  const auto add = [&](std::initializer_list<float> triangle) {
    for (float value : triangle) vertices.push_back(value);
  };
  add({5, 5, 0, 15, 5, 0, 5, 15, 0});
  add({kNan, 5, 0, 15, 5, 0, 5, 15, 0});
  add({5, 5, 0, kInf, 5, 0, 5, 15, 0});
  add({5, 5, 0, 15, 5, 0, 5, 15, -kInf});
  add({5, 5, 0, 5, 5, 0, 5, 15, 0});     // two corners in one place
  add({5, 5, 0, 10, 10, 0, 20, 20, 0});  // on a line
  add({9, 9, 9, 9, 9, 9, 9, 9, 9});      // a point
  add({40, 20, 0, 60, 20, 0, 40, 40, 0});
  drawTriangles(vertices);
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 6);
  EXPECT_EQ(pixel(8, 8), kWhite);
  EXPECT_EQ(pixel(45, 25), kWhite);
  EXPECT_EQ(pixel(30, 20), kBlack);
  EXPECT_CLEAN();
  context->endFrame();
  EXPECT_EQ(triangles(), 0);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 0);
}

TEST_F(DrawTest, TrianglesOfAnySizeAreLit) {
  for (const float size : {4e9f, 1e9f, 100.0f, 1e-10f}) {
    pixelCamera();
    paintDiffuse(1, 1, 1);
    lightFrom(0, 0, 1, 0, 0.5f);
    rcFrustum(-1, 1, -1, 1, 1, 100);
    rcuLookAt(0, 0, size, 0, 0, 0, 0, 1, 0);
    drawTriangles({-4 * size, -4 * size, 0, 4 * size, -4 * size, 0, 0, 4 * size, 0});
    rcFinish();
    EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 0) << size;
    EXPECT_EQ(pixel(32, 24), (Colour{128, 128, 128})) << size;
    context->endFrame();
  }
}

TEST_F(DrawTest, BadTrianglesOfTheStaticSceneAreCountedToo) {
  rcStaticSceneBegin();
  drawTriangles({kNan, 0, 0, 1, 0, 0, 0, 1, 0});
  drawQuad({10, 10, 30, 30});
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 1);
  EXPECT_EQ(pixel(20, 20), kWhite);
}

TEST_F(DrawTest, BadNormalsAndCoordinatesAreHarmless) {
  useVertices(kSquare);
  const float normals[] = {kNan, 0, 1, 0, 0, 0, kInf, 0, 0, 0, 0, 1};
  const float coordinates[] = {kNan, 0, kInf, 1, 1e30f, -1e30f, 0, 0};
  rcEnableClientState(RC_NORMAL_ARRAY);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcNormalPointer(RC_FLOAT, 0, normals);
  rcTexCoordPointer(2, RC_FLOAT, 0, coordinates);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  EXPECT_EQ(pixel(20, 20), kWhite);
  rcBindTexture(RC_TEXTURE_2D, 1);
  rcEnable(RC_TEXTURE_2D);
  loadSolid({200, 200, 200});
  rcEnable(RC_USE_TEXTURE_ONLY);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  EXPECT_EQ(pixel(28, 12), (Colour{200, 200, 200}));
}

TEST_F(DrawTest, SurfacesAreTwoSided) {
  const float colour[] = {0, 0, 0}, white[] = {1, 1, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, colour);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
  drawQuad({0, 0, 31.5f, 48});
  drawQuad({64, 0, 31.5f, 48});  // the other way round
  rcFinish();
  EXPECT_EQ(pixel(31, 24), (Colour{25, 25, 25}));  // 256 * 0.1, nearly straight
  EXPECT_EQ(pixel(32, 24), (Colour{25, 25, 25}));
}

// Captured by each draw: the switch at the time of the draw call counts.
TEST_F(DrawTest, TextureOnlyIsCapturedByTheDraw) {
  rcBindTexture(RC_TEXTURE_2D, 1);
  rcEnable(RC_TEXTURE_2D);
  loadSolid({100, 100, 100});
  rcEnable(RC_USE_TEXTURE_ONLY);
  drawTexturedQuad({0, 0, 31.5f, 48});
  rcDisable(RC_USE_TEXTURE_ONLY);
  drawTexturedQuad({31.5f, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(31, 24), (Colour{100, 100, 100}));
  EXPECT_EQ(pixel(32, 24), (Colour{110, 110, 110}));
}

TEST_F(DrawTest, TransmittanceShadowIsCapturedByTheDraw) {
  drawLitWall();
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 0.5f);
  rcEnable(RC_USE_TRANSMITTANCE_SHADOW);
  drawQuad({0, 0, 20, 48}, 100);  // behind the viewer
  rcDisable(RC_USE_TRANSMITTANCE_SHADOW);
  drawQuad({40, 0, 64, 48}, 100);
  rcFinish();
  EXPECT_EQ(pixel(15, 10), (Colour{64, 64, 64}));  // not on the diagonal
  EXPECT_EQ(pixel(30, 24), (Colour{128, 128, 128}));
  EXPECT_EQ(pixel(50, 24), kBlack);
}

TEST_F(DrawTest, TextureAlphaShadowIsCapturedByTheDraw) {
  drawLitWall();
  rcBindTexture(RC_TEXTURE_2D, 1);
  rcEnable(RC_TEXTURE_2D);
  rcTextureAlpha(4);  // opacity 1/4
  loadSolid({100, 100, 100});
  rcEnable(RC_USE_TEXTURE_ALPHA_SHADOW);
  drawTexturedQuad({0, 0, 20, 48}, 1, 1, 100);
  rcDisable(RC_USE_TEXTURE_ALPHA_SHADOW);
  drawTexturedQuad({40, 0, 64, 48}, 1, 1, 100);
  rcFinish();
  EXPECT_NEAR(pixel(15, 10)[0], 96, 1);  // not on the diagonal
  EXPECT_EQ(pixel(30, 24), (Colour{128, 128, 128}));
  EXPECT_EQ(pixel(50, 24), kBlack);
}

}  // namespace
}  // namespace rc::test
