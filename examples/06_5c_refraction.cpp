// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 6.5 c: a triangle behind a square of glass whose refraction index grows by 0.1 each frame.
// Both are static: materials are global, so static geometry follows them.
#include "RCFramework.h"
#include "common/pictures.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 6.5 c: refraction", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    makeTexture();
    makeMaterials();
    rcSceneAllInit();
    rcClearColor(0.4f, 0.3f, 0.2f, 0.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(70.0f, float(Width()) / float(Height()), 1.0f, 500.0f);
    rcuLookAt(-3, 0, 0, 0, 0, -8, 0, 1, 0);
    rcStaticSceneBegin();
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    drawTriangle();
    drawGlass();
    rcStaticSceneEnd();
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    rcBindMaterial(m_Materials[kGlass]);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, m_Index);
    m_Index += 0.1f;
    return TRUE;
  }

 private:
  void makeTexture() {
    const Picture clouds(128, 128, [](float u, float v, float *out) {
      const float cloud = cloudNoise(u, v, 4);
      out[0] = 0.5f + 0.4f * cloud, out[1] = 0.55f + 0.35f * cloud, out[2] = 0.65f + 0.25f * cloud;
    });
    rcGenTextures(1, &m_Texture);
    rcBindTexture(RC_TEXTURE_2D, m_Texture);
    rcTextureAlpha(128);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, clouds.width, clouds.height, 0, RC_RGB, RC_UNSIGNED_BYTE, clouds.rgb.data());
  }

  void makeMaterials() {
    static const float colours[2][3] = {{0.8f, 0.3f, 0.4f}, {0.2f, 0.4f, 0.8f}};
    static const float transmittance[] = {0.5f, 0.5f, 0.5f};
    rcGenMaterials(2, m_Materials);
    for (int i = 0; i < 2; ++i) {
      rcBindMaterial(m_Materials[i]);
      rcDisable(RC_TEXTURE_2D);
      rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colours[i]);
    }
    rcMaterialfv(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, transmittance);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, m_Index);
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
    rcPushMatrix();
    rcTranslatef(0, 0, -10);
    rcScalef(3, 3, 3);
    rcDrawArrays(RC_TRIANGLES, 0, 3);
    rcPopMatrix();
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }

  void drawGlass() const {
    static const float square[] = {2, -2, 0, 2, 2, 0, -2, 2, 0, -2, -2, 0};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, square);
    rcBindMaterial(m_Materials[kGlass]);
    rcPushMatrix();
    rcTranslatef(0, 0, -5);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcPopMatrix();
    rcDisableClientState(RC_VERTEX_ARRAY);
  }

  enum { kTriangle, kGlass };
  RCuint m_Materials[2] = {};
  RCuint m_Texture = 0;
  float m_Index = 1;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
