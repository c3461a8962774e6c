// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 d: first turned by 90 degrees, then moved by 1 along x: calls act in the reverse of their order.
#include "RCFramework.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 3.2 d: rotate, then translate", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcClearColor(0.73f, 0.2f, 0.23f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(60.0f, float(Width()) / float(Height()), 0.1f, 100.0f);
    rcuLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);
    drawStaticScene();
    return TRUE;
  }

  BOOL OnDraw() override {
    ++m_Frame;
    return !(IsTestMode() && m_Frame > 3);
  }

 private:
  // One yellow triangle. It never moves, so it is static: its structure is built once.
  void drawStaticScene() {
    static const float vertices[] = {0, 1, 0, -1, -1, 0, 1, -1, 0};
    static const RCubyte indices[] = {0, 1, 2};
    static const float yellow[] = {1, 1, 0};

    rcStaticSceneBegin();
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcTranslatef(1, 0, 0);
    rcRotatef(90, 0, 0, 1);
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

Tutorial g_Tutorial;
