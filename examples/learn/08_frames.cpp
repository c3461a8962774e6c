// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 8: a town that stands and a ball that moves. The town's structure is built once, the ball's each frame.
#include <cmath>

#include "RCFramework.h"
#include "common/box.h"
#include "common/pictures.h"
#include "common/sphere.h"

class Frames : public RCFramework {
 public:
  Frames() : RCFramework("Learn 8: frames", 800, 480), m_Sphere(48, 24) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.95f, 0.75f, 0.55f, 1);
    rcuPerspective(50, float(Width()) / float(Height()), 0.1f, 200);
    rcuLookAt(0, 9, 17, 0, 0.5f, 0, 0, 1, 0);
    const float sun[] = {0.8f, 0.7f, 0.5f, 0}, dim[] = {0.4f, 0.4f, 0.5f}, warm[] = {0.8f, 0.65f, 0.5f};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, sun);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, warm);
    rcStaticSceneBegin();
    drawTown();
    rcStaticSceneEnd();

    const float chrome[] = {0.85f, 0.85f, 0.85f}, dark[] = {0.05f, 0.05f, 0.05f};
    rcGenMaterials(1, &m_Chrome);
    rcBindMaterial(m_Chrome);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, dark);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, chrome);
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && m_Frame >= 3) return FALSE;
    const float angle = float(m_Frame++) * 0.05f;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcTranslatef(4 * std::sin(angle), 3.2f, 4 * std::cos(angle));
    rcScalef(1.5f, 1.5f, 1.5f);
    rcBindMaterial(m_Chrome);
    m_Sphere.draw();
    return TRUE;
  }

 private:
  static void drawTown() {
    for (int i = 0; i < 3; ++i) {
      RCuint material;
      rcGenMaterials(1, &material);
      rcBindMaterial(material);
      const float tone = 0.55f + 0.15f * float(i);
      rcColor4f(tone, 0.9f * tone, 0.8f * tone, 1);
      if (i == 0) drawBoxAt(0, -0.1f, 0, 60, 0.2f, 60);
      for (int x = -8; x <= 8; ++x) {
        for (int z = -8; z <= 8; ++z) {
          if ((x * x + z * z) % 3 != i) continue;
          const float height = 0.5f + 2.5f * gridNoise(x, z) * gridNoise(x, z);
          drawBoxAt(float(x) * 1.3f, height / 2, float(z) * 1.3f, 0.9f, height, 0.9f);
        }
      }
    }
  }

  Sphere m_Sphere;
  RCuint m_Chrome = 0;
  int m_Frame = 0;
};

Frames g_Program;
