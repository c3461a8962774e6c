// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 2: two rows of columns from the height of a man's eyes.
#include "RCFramework.h"
#include "common/box.h"

class Camera : public RCFramework {
 public:
  Camera() : RCFramework("Learn 2: the camera", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.55f, 0.7f, 0.9f, 1);
    rcuPerspective(50, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(0.8f, 1.7f, 8, 0, 1.6f, 0, 0, 1, 0);

    const float sun[] = {-0.5f, 1, 0.6f, 0}, ambient[] = {0.45f, 0.45f, 0.5f}, diffuse[] = {0.7f, 0.65f, 0.55f};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, sun);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, ambient);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, diffuse);

    rcStaticSceneBegin();
    paint(0.6f, 0.55f, 0.45f);
    drawBoxAt(0, -0.1f, -20, 200, 0.2f, 200);
    paint(0.9f, 0.85f, 0.75f);
    for (int i = 0; i < 10; ++i) {
      for (int side = -1; side <= 1; side += 2) drawBoxAt(float(side) * 2, 1.5f, 4 - 3 * float(i), 0.5f, 3, 0.5f);
    }
    paint(0.7f, 0.2f, 0.15f);
    drawBoxAt(0, 1, -26, 2, 2, 0.2f);
    rcStaticSceneEnd();
    return TRUE;
  }

 private:
  static void paint(float red, float green, float blue) {
    RCuint material;
    rcGenMaterials(1, &material);
    rcBindMaterial(material);
    rcColor4f(red, green, blue, 1);
  }
};

Camera g_Program;
