// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 6.5 a: three balls over a floor. Colour, highlight and exponent are properties of materials.
#include "RCFramework.h"
#include "common/sphere.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 6.5 a: Phong shading", 800, 480), m_Sphere(32, 32) {}

 protected:
  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcDepthBounce(14);
    rcClearColor(0.5f, 0.5f, 0.5f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(30, float(Width()) / float(Height()), 10, 10000);  // near is no clip plane: see the floor
    rcuLookAt(0, 0, 8, 0, 0, 0, 0, 1, 0);
    setLight();
    m_Right = makeMaterial({0, 1, 1}, {1, 0, 0}, 10);
    m_Left = makeMaterial({1, 0, 1}, {0, 1, 0}, 20);
    m_Middle = makeMaterial({1, 1, 0}, {0, 0, 1}, 30);
    m_Floor = makeMaterial({1, 1, 0}, {0, 0, 0}, 10);
    drawFloor();
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcTranslatef(0, 0, -7);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, m_Sphere.positions.data());
    rcNormalPointer(RC_FLOAT, 0, m_Sphere.positions.data());
    drawBall(m_Right, 2);
    drawBall(m_Left, -2);
    drawBall(m_Middle, 0);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcDisableClientState(RC_NORMAL_ARRAY);
    return TRUE;
  }

 private:
  struct Rgb {
    float r, g, b;
  };

  static void setLight() {
    static const float position[] = {-5, 5, 8, 1};
    static const float ambient[] = {0, 0, 0}, diffuse[] = {0.2f, 0.3f, 0.4f}, specular[] = {1, 1, 1};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, position);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, ambient);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, diffuse);
    rcLightfv(RC_LIGHT0, RC_SPECULAR, specular);
  }

  static RCuint makeMaterial(Rgb diffuse, Rgb specular, float exponent) {
    static const float ambient[] = {0, 0, 0};
    RCuint name;
    rcGenMaterials(1, &name);
    rcBindMaterial(name);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, ambient);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, &diffuse.r);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, &specular.r);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, exponent);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SPECULAR_LEVEL, 1);
    rcDisable(RC_TEXTURE_2D);
    return name;
  }

  void drawFloor() const {
    static const float square[] = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    rcBindMaterial(m_Floor);
    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, square);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcTranslatef(0, -1, -10);
    rcScalef(8, 1, 10);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();
  }

  void drawBall(RCuint material, float x) const {
    rcPushMatrix();
    rcBindMaterial(material);
    rcTranslatef(x, 0, 0);
    rcDrawArrays(RC_TRIANGLES, 0, m_Sphere.vertices());
    rcPopMatrix();
  }

  Sphere m_Sphere;
  RCuint m_Right = 0, m_Left = 0, m_Middle = 0, m_Floor = 0;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
