// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Client arrays: where vertices and indices come from. [spec 3.6]
#include "api/geometry_fixture.h"

namespace rc::test {
namespace {

constexpr RCenum kArrays[] = {RC_VERTEX_ARRAY, RC_NORMAL_ARRAY, RC_TEXTURE_COORD_ARRAY};

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

}  // namespace
}  // namespace rc::test
