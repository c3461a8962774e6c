// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 9.4: the Cornell box. The walls are static; two blocks are dynamic, and the short one jumps.
// An argument replaces the ambient part of the lights, 0.05.
#include "RCFramework.h"
#include "common/cornell.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 9.4: Cornell box", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcClearColor(0.0f, 0.2f, 0.4f, 1.0f);
    rcFrustum(-1, 1, -0.6f, 0.6f, 1.7, 1000);
    rcuLookAt(27.8f, 27.3f, -80.0f, 27.8f, 27.3f, 0, 0, 1, 0);

    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    drawWall(kLeftWall, {0.67f, 0.023f, 0.028f});
    drawWall(kRightWall, {0.026f, 0.234f, 0.026f});
    drawWall(kFloor, kWhite);
    drawWall(kCeiling, kWhite);
    drawWall(kBackWall, kWhite);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();

    rcGenMaterials(2, m_Blocks);
    setLights(m_Cmd.argc > 1 ? float(atof(m_Cmd.argv[1])) : 0.05f);
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    jump();
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcPushMatrix();
    rcTranslatef(0, m_Height, 0);
    drawBlock(kShortBlock, m_Blocks[0], {0.9f, 1.0f, 0.9f});
    rcPopMatrix();
    drawBlock(kTallBlock, m_Blocks[1], {0.9f, 0.9f, 1.0f});
    rcDisableClientState(RC_VERTEX_ARRAY);
    return TRUE;
  }

 private:
  struct Rgb {
    float r, g, b;
  };
  static constexpr Rgb kWhite{1, 1, 1};

  // Four lights just under the ceiling, at the corners of the opening of the real box.
  static void setLights(float ambientPart) {
    static const float positions[4][4] = {
        {34.3f, 54.87f, 22.7f, 1}, {34.3f, 54.87f, 33.2f, 1}, {21.3f, 54.87f, 33.2f, 1}, {21.3f, 54.87f, 22.7f, 1}};
    const float ambient[] = {ambientPart, ambientPart, ambientPart};
    static const float diffuse[] = {0.2f, 0.2f, 0.2f};
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcEnable(RC_LIGHTING);
    for (RCenum i = 0; i < 4; ++i) {
      rcLightfv(RC_LIGHT0 + i, RC_AMBIENT, ambient);
      rcLightfv(RC_LIGHT0 + i, RC_DIFFUSE, diffuse);
      rcLightfv(RC_LIGHT0 + i, RC_POSITION, positions[i]);
      rcEnable(RC_LIGHT0 + i);
    }
  }

  static void drawWall(const float *vertices, Rgb diffuse) {
    RCuint material;
    rcGenMaterials(1, &material);
    rcBindMaterial(material);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, &diffuse.r);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcDrawArrays(RC_TRIANGLES, 0, 6);
  }

  static void drawBlock(const float *vertices, RCuint material, Rgb colour) {
    rcBindMaterial(material);
    rcColor4f(colour.r, colour.g, colour.b, 0);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcDrawArrays(RC_TRIANGLES, 0, 30);
  }

  // Up and down between 0 and 10 by 0.1 a frame.
  void jump() {
    m_Height += m_Up ? 0.1f : -0.1f;
    if (m_Height < 0) m_Height = 0, m_Up = true;
    if (m_Height > 10) m_Height = 10, m_Up = false;
  }

  RCuint m_Blocks[2] = {};
  float m_Height = 0;
  bool m_Up = true;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
