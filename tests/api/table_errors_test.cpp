// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Errors that a group of functions has in common, raised by each function of the group.
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using TableErrorsTest = ContextTest;

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

}  // namespace
}  // namespace rc::test
