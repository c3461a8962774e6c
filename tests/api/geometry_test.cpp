// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Client arrays and draw calls. [spec 3.6]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

constexpr RCenum kArrays[] = {RC_VERTEX_ARRAY, RC_NORMAL_ARRAY, RC_TEXTURE_COORD_ARRAY};

class GeometryTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
  }

  void useVertices(const void *vertices, RCenum type = RC_FLOAT, RCsizei stride = 0) {
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, type, stride, vertices);
  }

  RCint triangles() {
    rcFinish();
    return integer(RC_FRAME_TRIANGLES);
  }
};

TEST_F(GeometryTest, InitialState) {
  for (RCenum array : kArrays) EXPECT_FALSE(rcIsEnabled(array));
  EXPECT_EQ(integer(RC_VERTEX_ARRAY_SIZE), 3);
  EXPECT_EQ(integer(RC_TEXTURE_COORD_ARRAY_SIZE), 2);
  for (RCenum type : {RC_VERTEX_ARRAY_TYPE, RC_NORMAL_ARRAY_TYPE, RC_TEXTURE_COORD_ARRAY_TYPE}) {
    EXPECT_EQ(integer(RCenum(type)), RC_FLOAT);
  }
  for (RCenum pname : {RC_VERTEX_ARRAY_POINTER, RC_NORMAL_ARRAY_POINTER, RC_TEXTURE_COORD_ARRAY_POINTER}) {
    RCvoid *pointer = &surface;
    rcGetPointerv(RCenum(pname), &pointer);
    EXPECT_EQ(pointer, nullptr);
  }
}

TEST_F(GeometryTest, PointersAreKept) {
  char memory[3] = {};
  rcVertexPointer(3, RC_SHORT, 20, &memory[0]);
  rcNormalPointer(RC_BYTE, 0, &memory[1]);
  rcTexCoordPointer(2, RC_FIXED, 0, &memory[2]);
  RCvoid *pointers[3] = {};
  rcGetPointerv(RC_VERTEX_ARRAY_POINTER, &pointers[0]);
  rcGetPointerv(RC_NORMAL_ARRAY_POINTER, &pointers[1]);
  rcGetPointerv(RC_TEXTURE_COORD_ARRAY_POINTER, &pointers[2]);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(pointers[i], &memory[i]);
  EXPECT_EQ(integer(RC_VERTEX_ARRAY_TYPE), RC_SHORT);
  EXPECT_EQ(integer(RC_VERTEX_ARRAY_STRIDE), 20);
  EXPECT_EQ(integer(RC_NORMAL_ARRAY_STRIDE), 3);  // packed
  EXPECT_EQ(integer(RC_TEXTURE_COORD_ARRAY_STRIDE), 8);
  for (RCenum array : kArrays) {
    rcEnableClientState(array);
    EXPECT_TRUE(rcIsEnabled(array));
    rcDisableClientState(array);
    EXPECT_FALSE(rcIsEnabled(array));
  }
  rcEnableClientState(RC_POINT_SIZE_ARRAY_OES);  // there are no points
  rcDisableClientState(RC_POINT_SIZE_ARRAY_OES);
  rcGetPointerv(RC_VERTEX_ARRAY_POINTER, nullptr);
  EXPECT_CLEAN();
}

TEST_F(GeometryTest, PointerErrors) {
  float memory[4] = {};
  rcVertexPointer(3, RC_FIXED, 16, memory);
  for (RCint size : {-1, 0, 2, 4}) EXPECT_RAISES(RC_INVALID_VALUE, rcVertexPointer(size, RC_FLOAT, 0, memory));
  for (RCint size : {-1, 0, 1, 3, 4}) EXPECT_RAISES(RC_INVALID_VALUE, rcTexCoordPointer(size, RC_FLOAT, 0, memory));
  EXPECT_RAISES(RC_INVALID_VALUE, rcVertexPointer(3, RC_FLOAT, -1, memory));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexCoordPointer(2, RC_FLOAT, -4, memory));
  EXPECT_RAISES(RC_INVALID_VALUE, rcNormalPointer(RC_FLOAT, -12, memory));
  for (RCenum type :
       {RCenum(RC_UNSIGNED_BYTE), RCenum(RC_UNSIGNED_SHORT), RCenum(RC_INT), RCenum(RC_DOUBLE), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcVertexPointer(3, type, 0, memory));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexCoordPointer(2, type, 0, memory));
    EXPECT_RAISES(RC_INVALID_ENUM, rcNormalPointer(type, 0, memory));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcEnableClientState(kNoToken));
  EXPECT_RAISES(RC_INVALID_ENUM, rcDisableClientState(RC_LIGHTING));
  RCvoid *pointer = memory;
  EXPECT_RAISES(RC_INVALID_ENUM, rcGetPointerv(RC_VERTEX_ARRAY, &pointer));
  EXPECT_EQ(pointer, memory);
}

TEST_F(GeometryTest, DrawErrors) {
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

TEST_F(GeometryTest, ModesAndIncompletePrimitives) {
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

TEST_F(GeometryTest, EveryModeShowsASquare) {
  const float strip[] = {10, 10, 0, 30, 10, 0, 10, 30, 0, 30, 30, 0};
  const float pair[] = {10, 10, 0, 30, 10, 0, 30, 30, 0, 10, 10, 0, 30, 30, 0, 10, 30, 0};
  const struct {
    RCenum mode;
    const float *vertices;
    RCsizei count;
  } cases[] = {
      {RC_QUADS, kSquare, 4}, {RC_TRIANGLE_FAN, kSquare, 4}, {RC_TRIANGLE_STRIP, strip, 4}, {RC_TRIANGLES, pair, 6}};
  for (const auto &[mode, vertices, count] : cases) {
    useVertices(vertices);
    rcDrawArrays(mode, 0, count);
    rcFinish();
    for (const auto &[x, y] : {std::pair{12, 14}, {28, 24}, {14, 28}, {28, 12}}) EXPECT_EQ(pixel(x, y), kWhite) << mode;
    EXPECT_EQ(pixel(35, 20), kBlack) << mode;
  }
}

// Front is where the vertices go counter-clockwise: there a dense material lets rays in, and all that meet its
// back at an angle are totally reflected. All triangles of a strip face alike.
TEST_F(GeometryTest, AStripFacesOneWay) {
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

TEST_F(GeometryTest, WithoutAVertexArrayNothingIsDrawn) {
  rcVertexPointer(3, RC_FLOAT, 0, kSquare);
  rcDrawArrays(RC_QUADS, 0, 4);
  EXPECT_CLEAN();
  EXPECT_EQ(triangles(), 0);
}

TEST_F(GeometryTest, AnEnabledArrayWithoutMemoryMakesTheDrawYieldNothing) {
  const RCubyte indices[] = {0, 1, 2, 3};
  for (RCenum array : kArrays) {
    useVertices(array == RC_VERTEX_ARRAY ? nullptr : kSquare);
    rcEnableClientState(array);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDrawElements(RC_QUADS, 4, RC_UNSIGNED_BYTE, indices);
    EXPECT_CLEAN();
    EXPECT_EQ(triangles(), 0);
    rcDisableClientState(array);
  }
}

TEST_F(GeometryTest, ADisabledArrayIsNotRead) {
  useVertices(kSquare);
  rcNormalPointer(RC_FLOAT, 0, reinterpret_cast<const void *>(8));
  rcTexCoordPointer(2, RC_FLOAT, 0, reinterpret_cast<const void *>(8));
  rcDrawArrays(RC_QUADS, 0, 4);
  EXPECT_EQ(triangles(), 2);
}

TEST_F(GeometryTest, EveryTypeOfVertex) {
  const RCbyte bytes[] = {10, 10, 0, 30, 10, 0, 30, 30, 0, 10, 30, 0};
  const RCshort shorts[] = {10, 10, 0, 30, 10, 0, 30, 30, 0, 10, 30, 0};
  RCfixed fixed[12];
  for (int i = 0; i < 12; ++i) fixed[i] = static_cast<RCfixed>(kSquare[i] * kFixedOne);
  const struct {
    RCenum type;
    const void *data;
  } cases[] = {{RC_BYTE, bytes}, {RC_SHORT, shorts}, {RC_FIXED, fixed}, {RC_FLOAT, kSquare}};
  for (const auto &[type, data] : cases) {
    useVertices(data, type);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcFinish();
    EXPECT_EQ(pixel(20, 20), kWhite) << type;
    EXPECT_EQ(pixel(20, 32), kBlack) << type;
    EXPECT_EQ(pixel(5, 20), kBlack) << type;
  }
}

TEST_F(GeometryTest, BytesAreSigned) {
  const RCbyte bytes[] = {-20, -20, 0, 20, -20, 0, 20, 20, 0, -20, 20, 0};
  rcTranslatef(32, 24, 0);
  useVertices(bytes, RC_BYTE);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  EXPECT_EQ(pixel(14, 24), kWhite);
  EXPECT_EQ(pixel(5, 24), kBlack);
}

TEST_F(GeometryTest, StrideFirstAndUnalignedMemory) {
  // A byte before each vertex of three shorts: 7 bytes apart, two vertices too many at the front.
  std::vector<unsigned char> memory(6 * 7, 0xEE);
  for (size_t i = 0; i < 4; ++i) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<RCshort>(kSquare[3 * i + axis]);
      std::memcpy(&memory[(i + 2) * 7 + 1 + 2 * axis], &value, 2);
    }
  }
  useVertices(memory.data() + 1, RC_SHORT, 7);
  rcDrawArrays(RC_QUADS, 2, 4);
  rcFinish();
  EXPECT_EQ(pixel(20, 20), kWhite);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 0);
}

TEST_F(GeometryTest, TheLastVertexMayEndTheAllocation) {
  const auto vertices = std::make_unique<float[]>(12);
  std::copy_n(kSquare, 12, vertices.get());
  useVertices(vertices.get());
  rcDrawArrays(RC_QUADS, 0, 4);
  EXPECT_EQ(triangles(), 2);
}

TEST_F(GeometryTest, MemoryIsReadDuringTheDrawCallOnly) {
  std::vector<float> vertices(std::begin(kSquare), std::end(kSquare));
  useVertices(vertices.data());
  rcDrawArrays(RC_QUADS, 0, 4);
  std::fill(vertices.begin(), vertices.end(), 1000.0f);
  vertices.clear();
  vertices.shrink_to_fit();
  rcFinish();
  EXPECT_EQ(pixel(20, 20), kWhite);
}

TEST_F(GeometryTest, IndicesOfEveryTypeAreUnsigned) {
  // The square is at the vertices from 200, 60000 and 70000 on; all others are not numbers.
  std::vector<float> vertices(70004 * 3, kNan);
  for (int base : {200, 60000, 70000}) std::copy_n(kSquare, 12, vertices.begin() + 3 * base);
  useVertices(vertices.data());
  const RCubyte bytes[] = {200, 201, 202, 203};
  const RCushort shorts[] = {60000, 60001, 60002, 60003};
  const RCuint ints[] = {70000, 70001, 70002, 70003};
  const struct {
    RCenum type;
    const void *data;
  } cases[] = {{RC_BYTE, bytes}, {RC_UNSIGNED_BYTE, bytes}, {RC_SHORT, shorts}, {RC_UNSIGNED_SHORT, shorts},
               {RC_INT, ints},   {RC_UNSIGNED_INT, ints}};
  for (const auto &[type, data] : cases) {
    rcDrawElements(RC_QUADS, 4, type, data);
    rcFinish();
    EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2) << type;
    EXPECT_EQ(pixel(20, 20), kWhite) << type;
  }
}

TEST_F(GeometryTest, NarrowIndicesNeverReachFurther) {
  std::vector<float> vertices(65536 * 3, kNan);
  std::copy_n(kSquare, 12, vertices.begin() + 3 * 252);  // the last four that a byte reaches
  useVertices(vertices.data());
  const RCubyte bytes[] = {252, 253, 254, 255};
  rcDrawElements(RC_QUADS, 4, RC_UNSIGNED_BYTE, bytes);
  EXPECT_EQ(triangles(), 2);
  std::copy_n(kSquare, 12, vertices.begin() + 3 * 65532);
  const RCushort shorts[] = {65532, 65533, 65534, 65535};
  rcDrawElements(RC_QUADS, 4, RC_UNSIGNED_SHORT, shorts);
  EXPECT_EQ(triangles(), 2);
}

TEST_F(GeometryTest, ManyVerticesAtOnce) {
  std::vector<float> vertices;
  for (int i = 0; i < 70000; ++i) {
    for (int value : {200 + i, i % 3, i % 2}) vertices.push_back(float(value));
  }
  useVertices(vertices.data());
  rcDrawArrays(RC_TRIANGLES, 0, 69999);
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES) + integer(RC_FRAME_TRIANGLES_SKIPPED), 23333);
}

TEST_F(GeometryTest, BadTrianglesAreSkippedAndCounted) {
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

TEST_F(GeometryTest, BadTrianglesOfTheStaticSceneAreCountedToo) {
  rcStaticSceneBegin();
  drawTriangles({kNan, 0, 0, 1, 0, 0, 0, 1, 0});
  drawQuad({10, 10, 30, 30});
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 1);
  EXPECT_EQ(pixel(20, 20), kWhite);
}

TEST_F(GeometryTest, BadNormalsAndCoordinatesAreHarmless) {
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

TEST_F(GeometryTest, SurfacesAreTwoSided) {
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
TEST_F(GeometryTest, TextureOnlyIsCapturedByTheDraw) {
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

TEST_F(GeometryTest, TransmittanceShadowIsCapturedByTheDraw) {
  const float black[] = {0, 0, 0}, white[] = {1, 1, 1}, half[] = {0.5f, 0.5f, 0.5f};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, half);
  drawQuad({0, 0, 64, 48});
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

TEST_F(GeometryTest, TextureAlphaShadowIsCapturedByTheDraw) {
  const float black[] = {0, 0, 0}, white[] = {1, 1, 1}, half[] = {0.5f, 0.5f, 0.5f};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, black);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, white);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, half);
  drawQuad({0, 0, 64, 48});
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
