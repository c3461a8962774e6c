// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Colours of vertices multiply the material's ambient and diffuse. [spec 3.6]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class ColorArrayTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_COLOR_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, kSquare);
  }
  void draw() {
    rcDrawArrays(RC_QUADS, 0, 4);
    rcFinish();
    context->endFrame();
    EXPECT_CLEAN();
  }
  static constexpr float kSquare[] = {0, 0, 0, 32, 0, 0, 32, 32, 0, 0, 32, 0};
};

TEST_F(ColorArrayTest, InitialState) {
  EXPECT_EQ(integer(RC_COLOR_ARRAY_SIZE), 4);
  EXPECT_EQ(integer(RC_COLOR_ARRAY_TYPE), RC_FLOAT);
  EXPECT_EQ(integer(RC_COLOR_ARRAY_STRIDE), 16);
  EXPECT_EQ(integer(RC_COLOR_ARRAY_BUFFER_BINDING), 0);
}

TEST_F(ColorArrayTest, IsInterpolated) {
  static const float colours[] = {0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1};
  paint(1, 1, 1);
  rcColorPointer(4, RC_FLOAT, 0, colours);
  draw();
  for (int x : {4, 16, 28}) EXPECT_NEAR(pixel(x, 16)[0], 256 * x / 32, 1);
}

TEST_F(ColorArrayTest, MultipliesTheMaterial) {
  static const RCubyte half[] = {51, 102, 255, 0, 51, 102, 255, 0, 51, 102, 255, 0, 51, 102, 255, 0};
  paint(0.5f, 0.5f, 0.5f);
  rcColorPointer(4, RC_UNSIGNED_BYTE, 0, half);
  draw();
  EXPECT_EQ(pixel(16, 16), (Colour{25, 51, 128}));
}

TEST_F(ColorArrayTest, EveryTypeOfWhite) {
  static const RCbyte bytes[16] = {127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127, 127};
  static const RCushort shorts[16] = {65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
                                      65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535};
  std::vector<RCshort> signedShorts(16, 32767);
  std::vector<RCfixed> fixed(16, kFixedOne);
  std::vector<float> tooMuch(16, 9.0f);
  paint(1, 1, 1);
  const std::pair<RCenum, const void *> kinds[] = {{RC_BYTE, bytes},
                                                   {RC_UNSIGNED_SHORT, shorts},
                                                   {RC_SHORT, signedShorts.data()},
                                                   {RC_FIXED, fixed.data()},
                                                   {RC_FLOAT, tooMuch.data()}};
  for (const auto &[type, data] : kinds) {
    rcColorPointer(4, type, 0, data);
    draw();
    EXPECT_EQ(pixel(16, 16), (Colour{255, 255, 255})) << type;
  }
}

TEST_F(ColorArrayTest, Errors) {
  const float colour[4] = {};
  EXPECT_RAISES(RC_INVALID_VALUE, rcColorPointer(3, RC_FLOAT, 0, colour));
  EXPECT_RAISES(RC_INVALID_VALUE, rcColorPointer(4, RC_FLOAT, -1, colour));
  EXPECT_RAISES(RC_INVALID_ENUM, rcColorPointer(4, RC_UNSIGNED_INT, 0, colour));
}

}  // namespace
}  // namespace rc::test
