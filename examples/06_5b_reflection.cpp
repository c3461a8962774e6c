// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 6.5 b: a triangle turns before a mirror. The mirror and its frame are static.
#include "RCFramework.h"
#include "common/pictures.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 6.5 b: reflection", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    makeTexture();
    makeMaterials();
    rcSceneAllInit();  // keeps textures and materials
    rcClearColor(0.2f, 0.2f, 0.2f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(60.0f, float(Width()) / float(Height()), 1.0f, 500.0f);
    rcuLookAt(-3, 0, 0, 0, 0, -8, 0, 1, 0);
    drawMirror();
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    drawTriangle();
    m_Angle += 10;
    return TRUE;
  }

 private:
  void makeTexture() {
    const Picture water(128, 128, [](float u, float v, float *out) {
      const float ripple = std::pow(1 - std::fabs(2 * cloudNoise(u, v, 8) - 1), 3.0f);
      out[0] = 0.1f + 0.3f * ripple, out[1] = 0.3f + 0.5f * ripple, out[2] = 0.8f + 0.2f * ripple;
    });
    rcGenTextures(1, &m_Texture);
    rcBindTexture(RC_TEXTURE_2D, m_Texture);
    rcTextureAlpha(128);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, water.width, water.height, 0, RC_RGB, RC_UNSIGNED_BYTE, water.rgb.data());
  }

  void makeMaterials() {
    static const float colours[3][3] = {{0.2f, 0.4f, 0.8f}, {0.0f, 0.8f, 0.4f}, {0.0f, 1.0f, 0.0f}};
    static const float whole[] = {1, 1, 1}, none[] = {0, 0, 0};
    rcGenMaterials(3, m_Materials);
    for (int i = 0; i < 3; ++i) {
      rcBindMaterial(m_Materials[i]);
      rcDisable(RC_TEXTURE_2D);
      rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colours[i]);
      rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, i == kMirror ? whole : none);
    }
    static const float ambient[] = {0.8f, 0.8f, 0.8f}, diffuse[] = {0.2f, 0.2f, 0.0f};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, ambient);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, diffuse);
  }

  void drawMirror() const {
    static const float square[] = {2, -2, 0, 2, 2, 0, -2, 2, 0, -2, -2, 0};
    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, square);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    drawSquare(m_Materials[kFrame], -10.0f, 2.0f);
    drawSquare(m_Materials[kMirror], -9.999f, 1.7f);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();
  }

  static void drawSquare(RCuint material, float z, float size) {
    rcPushMatrix();
    rcTranslatef(0, 0, z);
    rcScalef(size, size, size);
    rcBindMaterial(material);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcPopMatrix();
  }

  void drawTriangle() const {
    static const float vertices[] = {0, 0.707f, 0, -1, -0.707f, 0, 1, -0.707f, 0};
    static const float texCoords[] = {0.5f, 0, 0, 1, 1, 1};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    rcBindMaterial(m_Materials[kTriangle]);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, m_Texture);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcPushMatrix();
    rcTranslatef(0, 0, -5);
    rcRotatef(m_Angle, 0, 1, 0);
    rcDrawArrays(RC_TRIANGLES, 0, 3);
    rcPopMatrix();
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcBindMaterial(0);
  }

  enum { kFrame, kMirror, kTriangle };
  RCuint m_Materials[3] = {};
  RCuint m_Texture = 0;
  float m_Angle = 0;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
