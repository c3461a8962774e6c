// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Appendix C: a light travels round the Earth, before a background that shines by itself
// (RC_USE_TEXTURE_ONLY). The argument "black" or "white" paints the Earth so, to show the light alone.
#include <string.h>

#include "RCFramework.h"
#include "common/planet.h"
#include "common/sphere.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Appendix C: Earth", 800, 480), m_Sphere(128, 64) {}

 protected:
  BOOL OnIntialize() override {
    rcDepthBounce(14);
    rcSceneAllInit();
    rcClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(30, float(Width()) / float(Height()), 10, 10000);
    rcuLookAt(0, 0, 0, 0, 0, -1, 0, 1, 0);
    makeTextures();
    makeMaterials();
    makeLight();
    drawSky();
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcPushMatrix();
    rcRotatef(m_Turn, 0, 1, 0);
    rcLightfv(RC_LIGHT0, RC_POSITION, kLightPosition);  // transformed like geometry
    rcPopMatrix();
    drawEarth();
    m_Turn = m_Turn + 5 == 360 ? 0 : m_Turn + 5;
    return TRUE;
  }

 private:
  static void load(RCuint name, const Picture &picture) {
    rcBindTexture(RC_TEXTURE_2D, name);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, picture.width, picture.height, 0, RC_RGB, RC_UNSIGNED_BYTE,
                 picture.rgb.data());
  }

  void makeTextures() {
    rcGenTextures(2, m_Textures);
    load(m_Textures[kSky], starField(512, 256));
    const char *paint = m_Cmd.argc > 1 ? m_Cmd.argv[1] : "";
    if (!strcmp(paint, "black") || !strcmp(paint, "white")) {
      const float shade = *paint == 'w' ? 1.0f : 0.0f;
      load(m_Textures[kEarth], Picture(16, 16, [=](float, float, float *out) { out[0] = out[1] = out[2] = shade; }));
    } else {
      load(m_Textures[kEarth], planet(512, 256));
    }
  }

  // The texture is enabled once: each new material is a copy of the one bound before it.
  void makeMaterials() {
    static const float colours[2][3] = {{0.588235f, 0.588235f, 0.588235f}, {0.529412f, 0.529412f, 0.529412f}};
    static const float speculars[2][3] = {{0, 0, 0}, {1, 0, 0}};
    static const float exponents[2] = {2.000000f, 3.031433f};
    rcEnable(RC_TEXTURE_2D);
    for (int i = 0; i < 2; ++i) {
      rcGenMaterials(1, &m_Materials[i]);
      rcBindMaterial(m_Materials[i]);
      rcBindTexture(RC_TEXTURE_2D, m_Textures[i]);
      rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colours[i]);
      rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, speculars[i]);
      rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, exponents[i]);
    }
  }

  static void makeLight() {
    static const float black[] = {0, 0, 0}, white[] = {1, 1, 1};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, kLightPosition);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, black);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, white);
    rcLightfv(RC_LIGHT0, RC_SPECULAR, white);
  }

  void drawSky() const {
    static const float vertices[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static const float texCoords[] = {0, 0, 1, 0, 1, 1, 0, 1};
    rcBindMaterial(m_Materials[kSky]);
    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcTranslatef(0, 0, -18);
    rcScalef(8, 4.8f, 1);
    rcEnable(RC_USE_TEXTURE_ONLY);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcDisable(RC_USE_TEXTURE_ONLY);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcStaticSceneEnd();
  }

  void drawEarth() const {
    rcTranslatef(0, 0, -7);
    rcRotatef(35, 0, 1, 0);
    rcRotatef(15, 1, 0, 0);
    rcBindMaterial(m_Materials[kEarth]);
    m_Sphere.draw();
  }

  static constexpr float kLightPosition[4] = {-17.802584f, 0.353599f, 8.770458f, 1};
  enum { kSky, kEarth };
  Sphere m_Sphere;
  RCuint m_Textures[2] = {}, m_Materials[2] = {};
  float m_Turn = 35;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
