// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// RAYCORE_MEMORY_LIMIT: whatever a program makes large is refused with RC_OUT_OF_MEMORY before it is there, and the
// context draws on.
#include "api/context_fixture.h"
#include "base/memory.h"

namespace rc::test {
namespace {

class MemoryLimitTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 0, 0);
    drawQuad({0, 0, kWidth, kHeight});
    trace();  // queues have their memory now
  }
  void TearDown() override {
    setMemoryLimit(mOld);
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
    paint(0, 1, 0);
    drawQuad({0, 0, kWidth, kHeight});
    trace();
    EXPECT_EQ(pixel(5, 5), (Colour{0, 255, 0})) << "it draws on";
    ContextTest::TearDown();
  }

  static void leave(size_t bytes) { setMemoryLimit(countedMemory() + bytes); }

  void expectRefused(const char *what) const {
    EXPECT_EQ(rcGetError(), RCenum(RC_OUT_OF_MEMORY)) << what;
    EXPECT_NE(message.find("RAYCORE_MEMORY_LIMIT"), std::string::npos) << message;
  }

  const uint64_t mOld = memoryLimit();
};

TEST_F(MemoryLimitTest, Textures) {
  const std::vector<RCubyte> texels(size_t(1024) * 1024 * 4, 100);
  leave(1 << 20);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 1024, 1024, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
  expectRefused("texels");
  leave(9 << 19);  // for the image alone
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 1024, 1024, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
  expectRefused("mip levels");
}

// The first draw ends the frame before, whose triangles nothing may look for any more.
TEST_F(MemoryLimitTest, ADrawAfterATracedFrame) {
  const std::vector<float> vertices(9 * 300000);
  for (int i = 0; i < 100; ++i) {  // values of their own for each
    paint(0.01f * float(i), 0, 0);
    drawQuad({0, 0, kWidth, kHeight});
  }
  trace();
  leave(1 << 20);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  rcDrawArrays(RC_TRIANGLES, 0, 900000);
  rcDisableClientState(RC_VERTEX_ARRAY);
  expectRefused("triangles");
  setMemoryLimit(mOld);
  RCfloat distance = 0, material = 0;
  rcReadRaysRCX(5, 5, 1, 1, RC_RAY_DISTANCE, &distance);
  rcReadRaysRCX(5, 5, 1, 1, RC_RAY_MATERIAL, &material);
  EXPECT_EQ(distance, -1) << "the new frame is empty";
  EXPECT_EQ(pixel(5, 5), kBlack) << "and so is its picture";
}

TEST_F(MemoryLimitTest, Buffers) {
  rcBindBuffer(RC_ARRAY_BUFFER, 1);
  leave(1 << 20);
  rcBufferData(RC_ARRAY_BUFFER, RCsizeiptr(1) << 30, nullptr, RC_STATIC_DRAW);
  expectRefused("a buffer");
  rcBindBuffer(RC_ARRAY_BUFFER, 0);
}

TEST_F(MemoryLimitTest, TrianglesAndStructures) {
  std::vector<float> vertices;
  for (int i = 0; i < 30000; ++i) {
    const float x = float(i % 173), y = float(i / 173 % 173);
    vertices.insert(vertices.end(), {x, y, 0, x + 1, y, 0, x, y + 1, 1});
  }
  leave(1 << 20);
  drawTriangles(vertices);
  expectRefused("triangles");
  for (const RCenum structure : {RC_STRUCTURE_KD_TREE, RC_STRUCTURE_BVH}) {
    rcHint(RC_STRUCTURE_HINT, structure);
    setMemoryLimit(mOld);
    rcStaticSceneBegin();
    drawTriangles(vertices);
    EXPECT_CLEAN();
    leave(1 << 19);
    rcStaticSceneEnd();
    expectRefused("a structure");
  }
  setMemoryLimit(mOld);
  drawTriangles(vertices);
  leave(1 << 19);
  rcFinish();
  expectRefused("a structure of a frame");
  setMemoryLimit(mOld);
  rcSceneAllInit();
}

TEST_F(MemoryLimitTest, ManySmallThingsCountToo) {
  leave(1 << 20);
  const std::vector<RCubyte> texels(size_t(32) * 32 * 4, 100);
  RCuint name = 1;
  for (; name < 1000; ++name) {
    rcBindTexture(RC_TEXTURE_2D, name);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 32, 32, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
    if (rcGetError() == RC_OUT_OF_MEMORY) break;
  }
  EXPECT_GT(name, 100u);
  EXPECT_LT(name, 300u);
  rcBindTexture(RC_TEXTURE_2D, 0);
}

}  // namespace
}  // namespace rc::test
