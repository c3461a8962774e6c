// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 4.2: a light turns round a textured planet: its position passes through the modelview matrix. A
// second light is a spot from above with a soft edge; a third one fades with distance.
#include "RCFramework.h"
#include "common/planet.h"
#include "common/sphere.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 4.2: lights", 800, 480), m_Sphere(96, 48) {}

 protected:
  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcClearColor(0.02f, 0.02f, 0.04f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(40, float(Width()) / float(Height()), 1, 1000);
    rcuLookAt(0, 2.5f, 7, 0, -0.2f, 0, 0, 1, 0);
    makeMaterials();
    makeLights();
    drawFloor();
    return TRUE;
  }

  BOOL OnDraw() override {
    static const float position[] = {3, 1.5f, 3, 1};
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcPushMatrix();
    rcRotatef(m_Turn, 0, 1, 0);
    rcLightfv(RC_LIGHT0, RC_POSITION, position);
    rcPopMatrix();
    drawPlanet();
    m_Turn += 5;
    return TRUE;
  }

 private:
  void makeMaterials() {
    static const float none[] = {0, 0, 0}, grey[] = {0.8f, 0.8f, 0.75f}, shine[] = {0.4f, 0.4f, 0.4f};
    const Picture map = planet(256, 128);
    RCuint texture;
    rcGenTextures(1, &texture);
    rcGenMaterials(2, m_Materials);
    rcBindMaterial(m_Materials[0]);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, texture);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, map.width, map.height, 0, RC_RGB, RC_UNSIGNED_BYTE, map.rgb.data());
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, shine);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 20);
    rcBindMaterial(m_Materials[1]);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, grey);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, none);
  }

  struct Lamp {
    float position[4], ambient[3], diffuse[3], specular[3];
  };

  static void setLight(RCenum light, const Lamp &lamp) {
    rcEnable(light);
    rcLightfv(light, RC_POSITION, lamp.position);
    rcLightfv(light, RC_AMBIENT, lamp.ambient);
    rcLightfv(light, RC_DIFFUSE, lamp.diffuse);
    rcLightfv(light, RC_SPECULAR, lamp.specular);
  }

  static void makeLights() {
    static const float down[] = {0, -1, 0};
    rcEnable(RC_LIGHTING);
    setLight(RC_LIGHT0, {{3, 1.5f, 3, 1}, {0.08f, 0.08f, 0.1f}, {0.8f, 0.8f, 0.7f}, {1, 1, 1}});

    setLight(RC_LIGHT1, {{-2.5f, 3, 0, 1}, {0, 0, 0}, {0.9f, 0.5f, 0.2f}, {0, 0, 0}});
    rcLightfv(RC_LIGHT1, RC_SPOT_DIRECTION, down);
    rcLightf(RC_LIGHT1, RC_SPOT_INNER_CONE, 12);
    rcLightf(RC_LIGHT1, RC_SPOT_OUTER_CONE, 22);

    setLight(RC_LIGHT2, {{2.6f, -0.4f, 1, 1}, {0, 0, 0}, {0.2f, 0.6f, 1.0f}, {0, 0, 0}});
    rcLightf(RC_LIGHT2, RC_CONSTANT_ATTENUATION, 0.5f);
    rcLightf(RC_LIGHT2, RC_LINEAR_ATTENUATION, 0.5f);
    rcLightf(RC_LIGHT2, RC_QUADRATIC_ATTENUATION, 1.0f);
  }

  void drawFloor() const {
    static const float square[] = {-6, -1.2f, 5, 6, -1.2f, 5, 6, -1.2f, -6, -6, -1.2f, -6};
    rcBindMaterial(m_Materials[1]);
    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, square);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();
  }

  void drawPlanet() const {
    rcBindMaterial(m_Materials[0]);
    m_Sphere.draw();
  }

  Sphere m_Sphere;
  RCuint m_Materials[2] = {};
  float m_Turn = 0;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
