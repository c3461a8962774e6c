// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// geometry_fixture.h: draw calls whose units are pixels, in white.
#pragma once

#include "api/context_fixture.h"

namespace rc::test {

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

}  // namespace rc::test
