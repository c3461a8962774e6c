// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 1: a window, a camera, a triangle.
#include "RCFramework.h"

class FirstFrame : public RCFramework {
 public:
  FirstFrame() : RCFramework("Learn 1: the first frame", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.1f, 0.1f, 0.2f, 1);
    rcuPerspective(60, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(0, 0, 3, 0, 0, 0, 0, 1, 0);
    return TRUE;
  }

  BOOL OnDraw() override {
    static const float corners[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
    rcColor4f(1.0f, 0.6f, 0.1f, 1.0f);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, corners);
    rcDrawArrays(RC_TRIANGLES, 0, 3);
    return TRUE;
  }
};

FirstFrame g_Program;
