// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 3: an arm of three parts. Each part is placed where the one before it ends.
#include <cmath>

#include "RCFramework.h"
#include "common/box.h"

class Transforms : public RCFramework {
 public:
  Transforms() : RCFramework("Learn 3: transforms", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.12f, 0.14f, 0.18f, 1);
    rcuPerspective(45, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(0, 2.5f, 8, 0, 1.4f, 0, 0, 1, 0);
    const float lamp[] = {3, 6, 5, 1}, dim[] = {0.3f, 0.3f, 0.3f}, bright[] = {0.8f, 0.8f, 0.8f};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, lamp);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, bright);
    for (RCuint &material : m_Materials) rcGenMaterials(1, &material);
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && m_Frame >= 3) return FALSE;
    const float bend = 30 + 25 * std::sin(float(m_Frame++) * 0.1f);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    paint(0, 0.35f, 0.37f, 0.4f);
    drawBoxAt(0, -0.1f, 0, 6, 0.2f, 4);
    rcPushMatrix();
    for (int part = 0; part < 3; ++part) {
      const float length = 1.6f - 0.3f * float(part);
      rcRotatef(part == 0 ? 40 - bend : bend, 0, 0, 1);  // the joint
      paint(part + 1, 0.9f, 0.3f + 0.2f * float(part), 0.15f);
      drawBoxAt(0, length / 2, 0, 0.5f - 0.1f * float(part), length, 0.5f - 0.1f * float(part));
      rcTranslatef(0, length, 0);  // to its end: the next part begins there
    }
    rcPopMatrix();
    return TRUE;
  }

 private:
  void paint(int material, float red, float green, float blue) const {
    rcBindMaterial(m_Materials[material]);
    rcColor4f(red, green, blue, 1);
  }

  RCuint m_Materials[4] = {};
  int m_Frame = 0;
};

Transforms g_Program;
