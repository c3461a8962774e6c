// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Buffer objects: names, data, arrays and indices in them, every error. [reference 1.3, 4.7]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

constexpr RCubyte kIndices[] = {9, 9, 0, 1, 2, 0, 2, 3};

class BufferTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
    rcGenBuffers(2, names);
  }

  RCint parameter(RCenum pname, RCenum target = RC_ARRAY_BUFFER) {
    RCint value = -1;
    rcGetBufferParameteriv(target, pname, &value);
    return value;
  }
  void loadSquare(RCenum usage = RC_STATIC_DRAW) {
    rcBindBuffer(RC_ARRAY_BUFFER, names[0]);
    rcBufferData(RC_ARRAY_BUFFER, sizeof kSquare, kSquare, usage);
  }
  RCint triangles() {
    rcFinish();
    return integer(RC_FRAME_TRIANGLES);
  }

  RCuint names[2] = {};
};

TEST_F(BufferTest, NamesAndInitialState) {
  EXPECT_EQ(names[0], 1u);
  EXPECT_EQ(names[1], 2u);
  EXPECT_TRUE(rcIsBuffer(0));
  EXPECT_TRUE(rcIsBuffer(1));
  EXPECT_FALSE(rcIsBuffer(3));
  EXPECT_EQ(integer(RC_ARRAY_BUFFER_BINDING), 0);
  EXPECT_EQ(integer(RC_ELEMENT_ARRAY_BUFFER_BINDING), 0);
  rcBindBuffer(RC_ARRAY_BUFFER, 7);  // an unused name is made
  EXPECT_TRUE(rcIsBuffer(7));
  EXPECT_EQ(integer(RC_ARRAY_BUFFER_BINDING), 7);
  EXPECT_EQ(parameter(RC_BUFFER_SIZE), 0);
  EXPECT_EQ(parameter(RC_BUFFER_USAGE), RC_STATIC_DRAW);
  const RCuint dead[] = {0, 1, 7, 99};
  rcDeleteBuffers(4, dead);
  EXPECT_FALSE(rcIsBuffer(1));
  EXPECT_EQ(integer(RC_ARRAY_BUFFER_BINDING), 0);
  RCuint next = 0;
  rcGenBuffers(1, &next);
  EXPECT_EQ(next, 1u) << "the lowest free name";
  EXPECT_CLEAN();
}

TEST_F(BufferTest, DataAndUsage) {
  loadSquare(RC_DYNAMIC_DRAW);
  EXPECT_EQ(parameter(RC_BUFFER_SIZE), RCint(sizeof kSquare));
  EXPECT_EQ(parameter(RC_BUFFER_USAGE), RC_DYNAMIC_DRAW);
  rcBufferData(RC_ARRAY_BUFFER, 12, nullptr, RC_STATIC_DRAW);
  EXPECT_EQ(parameter(RC_BUFFER_SIZE), 12);
  EXPECT_CLEAN();
}

TEST_F(BufferTest, DrawsWhatClientMemoryDraws) {
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, kSquare);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  const std::vector<uint32_t> fromMemory = surface.pixels;
  context->endFrame();
  surface.fill(0);
  loadSquare();
  rcVertexPointer(3, RC_FLOAT, 0, offset(0));
  rcBindBuffer(RC_ARRAY_BUFFER, 0);  // the array keeps its buffer
  EXPECT_EQ(integer(RC_VERTEX_ARRAY_BUFFER_BINDING), 1);
  rcBindBuffer(RC_ELEMENT_ARRAY_BUFFER, names[1]);
  rcBufferData(RC_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, RC_STATIC_DRAW);
  rcDrawElements(RC_TRIANGLES, 6, RC_UNSIGNED_BYTE, offset(2));
  rcFinish();
  EXPECT_EQ(surface.pixels, fromMemory);
  EXPECT_EQ(pixel(20, 20), (Colour{255, 255, 255}));
  EXPECT_CLEAN();
}

TEST_F(BufferTest, SubDataMovesAVertex) {
  loadSquare(RC_DYNAMIC_DRAW);
  const float corner[] = {40, 30, 0};
  rcBufferSubData(RC_ARRAY_BUFFER, 6 * sizeof(float), sizeof corner, corner);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, offset(0));
  rcDrawArrays(RC_QUADS, 0, 4);
  rcFinish();
  EXPECT_EQ(pixel(36, 28), (Colour{255, 255, 255}));
  EXPECT_CLEAN();
}

TEST_F(BufferTest, NothingBeyondTheEndIsRead) {
  loadSquare();
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, offset(12));  // three vertices are left
  rcDrawArrays(RC_TRIANGLES, 0, 3000);
  EXPECT_EQ(triangles(), 1);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES_SKIPPED), 999);
  context->endFrame();
  const RCuint far[] = {0, 1, 0xffffffff};
  rcDrawElements(RC_TRIANGLES, 3, RC_UNSIGNED_INT, far);
  EXPECT_EQ(triangles(), 0);
  context->endFrame();
  rcBindBuffer(RC_ELEMENT_ARRAY_BUFFER, names[1]);
  rcBufferData(RC_ELEMENT_ARRAY_BUFFER, 8, nullptr, RC_STATIC_DRAW);
  rcDrawElements(RC_TRIANGLES, 1000000, RC_UNSIGNED_SHORT, offset(6));
  rcDrawElements(RC_TRIANGLES, 3, RC_UNSIGNED_INT, offset(1000));
  EXPECT_EQ(triangles(), 0);
  EXPECT_CLEAN();
}

TEST_F(BufferTest, ADeletedOrSmallerBufferDoesNoHarm) {
  loadSquare();
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, offset(12));
  rcBufferData(RC_ARRAY_BUFFER, 4, nullptr, RC_STATIC_DRAW);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  EXPECT_EQ(triangles(), 0);
  rcBufferData(RC_ARRAY_BUFFER, 0, nullptr, RC_STATIC_DRAW);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  EXPECT_EQ(triangles(), 0);
  rcDeleteBuffers(1, names);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  EXPECT_EQ(triangles(), 0);
  EXPECT_CLEAN();
}

TEST_F(BufferTest, Errors) {
  RCint value = 0;
  EXPECT_RAISES(RC_INVALID_VALUE, rcGenBuffers(-1, names));
  EXPECT_RAISES(RC_INVALID_VALUE, rcDeleteBuffers(-1, names));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBindBuffer(kNoToken, 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBufferData(kNoToken, 4, kSquare, RC_STATIC_DRAW));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBufferSubData(kNoToken, 0, 4, kSquare));
  EXPECT_RAISES(RC_INVALID_ENUM, rcGetBufferParameteriv(kNoToken, RC_BUFFER_SIZE, &value));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcBufferData(RC_ARRAY_BUFFER, 4, kSquare, RC_STATIC_DRAW));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcBufferSubData(RC_ARRAY_BUFFER, 0, 4, kSquare));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcGetBufferParameteriv(RC_ARRAY_BUFFER, RC_BUFFER_SIZE, &value));
  rcBindBuffer(RC_ARRAY_BUFFER, names[0]);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcVertexPointer(3, RC_FLOAT, 0, offset(0)));  // no data
  loadSquare(RC_DYNAMIC_DRAW);
  EXPECT_RAISES(RC_INVALID_ENUM, rcBufferData(RC_ARRAY_BUFFER, 4, kSquare, kNoToken));
  EXPECT_RAISES(RC_INVALID_VALUE, rcBufferData(RC_ARRAY_BUFFER, -1, kSquare, RC_STATIC_DRAW));
  EXPECT_RAISES(RC_INVALID_ENUM, rcGetBufferParameteriv(RC_ARRAY_BUFFER, kNoToken, &value));
  EXPECT_RAISES(RC_INVALID_VALUE, rcVertexPointer(3, RC_FLOAT, 0, offset(sizeof kSquare)));
  for (const auto &[start, size] : {std::pair<RCintptr, RCsizeiptr>{-1, 4},
                                    {0, -1},
                                    {0, 0},
                                    {48, 1},
                                    {40, 9},
                                    {1, std::numeric_limits<RCsizeiptr>::max()}}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcBufferSubData(RC_ARRAY_BUFFER, start, size, kSquare));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcBufferSubData(RC_ARRAY_BUFFER, 0, 4, nullptr));
  loadSquare(RC_STATIC_DRAW);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcBufferSubData(RC_ARRAY_BUFFER, 0, 4, kSquare));
  rcBindBuffer(RC_ELEMENT_ARRAY_BUFFER, names[1]);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcDrawElements(RC_TRIANGLES, 3, RC_UNSIGNED_BYTE, offset(0)));  // empty
  EXPECT_RAISES(RC_OUT_OF_MEMORY,
                rcBufferData(RC_ARRAY_BUFFER, std::numeric_limits<RCsizeiptr>::max() - 8, nullptr, RC_STATIC_DRAW));
}

}  // namespace
}  // namespace rc::test
