// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Errors that a group of functions has in common, raised by each function of the group.
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using TableErrorsTest = ContextTest;

const RCvoid *offset(size_t bytes) { return reinterpret_cast<const RCvoid *>(bytes); }

TEST_F(TableErrorsTest, PointersIntoBuffers) {
  RCuint buffer = 0;
  rcGenBuffers(1, &buffer);
  rcBindBuffer(RC_ARRAY_BUFFER, buffer);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcVertexPointer(3, RC_FLOAT, 0, offset(0)));  // no data
  EXPECT_RAISES(RC_INVALID_OPERATION, rcNormalPointer(RC_FLOAT, 0, offset(0)));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexCoordPointer(2, RC_FLOAT, 0, offset(0)));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcColorPointer(4, RC_FLOAT, 0, offset(0)));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcPointSizePointerOES(RC_FLOAT, 0, offset(0)));
  rcBufferData(RC_ARRAY_BUFFER, 64, nullptr, RC_STATIC_DRAW);
  EXPECT_RAISES(RC_INVALID_VALUE, rcVertexPointer(3, RC_FLOAT, 0, offset(64)));
  EXPECT_RAISES(RC_INVALID_VALUE, rcNormalPointer(RC_FLOAT, 0, offset(64)));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexCoordPointer(2, RC_FLOAT, 0, offset(64)));
  EXPECT_RAISES(RC_INVALID_VALUE, rcColorPointer(4, RC_FLOAT, 0, offset(64)));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointSizePointerOES(RC_FLOAT, 0, offset(64)));
}

TEST_F(TableErrorsTest, OpaqueAlphaOfTextures) {
  const RCfloat none = 0;
  const RCint tooMuch = 256;
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameterf(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, none));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, tooMuch));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameterx(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, tooMuch));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameterfv(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, &none));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameteriv(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, &tooMuch));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameterxv(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, &tooMuch));
}

TEST_F(TableErrorsTest, ImagesOfTextures) {
  const std::vector<RCubyte> texels(size_t{16} * 16 * 4);
  const auto *p = texels.data();
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexImage2D(kNoToken, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, p));
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, kNoToken, p));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexImage2D(RC_TEXTURE_2D, 1, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, p));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 17, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, p));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, p));
}

TEST_F(TableErrorsTest, MatricesOfThePaletteWhileItIsOff) {
  const std::vector<RCfixed> zero(16);
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  rcDisable(RC_MATRIX_PALETTE_OES);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcLoadMatrixx(zero.data()));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMultMatrixx(zero.data()));
}

// The call itself is not undone: the static scene is dropped, and the rest is traced.
TEST_F(TableErrorsTest, AStaticSceneThatIsNotEnded) {
  context->attach(&surface);
  rcStaticSceneBegin();
  EXPECT_RAISES(RC_INVALID_OPERATION, rcFinish());
  rcStaticSceneBegin();
  EXPECT_RAISES(RC_INVALID_OPERATION, rcFlush());
}

}  // namespace
}  // namespace rc::test
