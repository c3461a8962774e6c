// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// triangle_program.h: what the programs of chapters 2 and 3 share: one yellow triangle on red, in a static scene.
// A program says how it looks at the triangle and where it puts it.
#pragma once

#include "RCFramework.h"

class TriangleProgram : public RCFramework {
 public:
  explicit TriangleProgram(const char *title) : RCFramework(title, 800, 480) {}

 protected:
  virtual void setCamera() {
    rcuPerspective(60.0f, float(Width()) / float(Height()), 0.1f, 100.0f);
    rcuLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);
  }
  // Changes the modelview matrix, which is the identity before.
  virtual void placeTriangle() = 0;

  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcClearColor(0.73f, 0.2f, 0.23f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    setCamera();
    drawStaticScene();
    return TRUE;
  }

  // Nothing moves. In test mode a program of the guide ends after three frames.
  BOOL OnDraw() override { return !(IsTestMode() && ++m_Frame > 3); }

 private:
  // The triangle never moves, so it is static: its structure is built once.
  void drawStaticScene() {
    static const float vertices[] = {0, 1, 0, -1, -1, 0, 1, -1, 0};
    static const RCubyte indices[] = {0, 1, 2};
    static const float yellow[] = {1, 1, 0};

    rcStaticSceneBegin();
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    placeTriangle();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcBindMaterial(1);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, yellow);
    rcDrawElements(RC_TRIANGLE_FAN, 3, RC_UNSIGNED_BYTE, indices);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();
  }

  int m_Frame = 0;
};
