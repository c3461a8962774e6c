// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 5.5: textures are made once and belong to materials. From left to right: RGB bytes, packed 5-6-5
// shorts repeated three times, and RGBA with holes that rays pass; under them a checkered floor on mip levels.
#include "RCFramework.h"
#include "common/pictures.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Chapter 5.5: textures", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcSceneAllInit();
    rcClearColor(0.45f, 0.6f, 0.8f, 1.0f);
    rcViewport(0, 0, Width(), Height());
    rcuPerspective(45, float(Width()) / float(Height()), 1, 1000);
    rcuLookAt(0, 1.6f, 6, 0, 0.3f, 0, 0, 1, 0);
    rcGenTextures(4, m_Textures);
    rcGenMaterials(4, m_Materials);
    loadBricks();
    loadShorts();
    loadLattice();
    loadCheckers();
    for (int i = 0; i < 4; ++i) {
      rcBindMaterial(m_Materials[i]);
      rcEnable(RC_TEXTURE_2D);
      rcBindTexture(RC_TEXTURE_2D, m_Textures[i]);
    }
    drawScene();
    return TRUE;
  }

  BOOL OnDraw() override { return !(IsTestMode() && ++m_Frame > 3); }

 private:
  void loadBricks() const {
    const Picture bricks(128, 128, [](float u, float v, float *out) {
      const float row = std::floor(v * 8), x = u * 4 + 0.5f * std::fmod(row, 2.0f);
      const bool mortar = x - std::floor(x) < 0.06f || v * 8 - row < 0.12f;
      const float tone = 0.7f + 0.3f * gridNoise(int(std::floor(x)) % 4, int(row));
      out[0] = mortar ? 0.8f : 0.65f * tone, out[1] = mortar ? 0.78f : 0.3f * tone,
      out[2] = mortar ? 0.7f : 0.2f * tone;
    });
    rcBindTexture(RC_TEXTURE_2D, m_Textures[0]);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 128, 128, 0, RC_RGB, RC_UNSIGNED_BYTE, bricks.rgb.data());
  }

  void loadShorts() const {
    std::vector<RCushort> texels;
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) texels.push_back(RCushort(x << 11 | (y * 2) << 5 | (31 - x)));
    }
    rcBindTexture(RC_TEXTURE_2D, m_Textures[1]);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 32, 32, 0, RC_RGB, RC_UNSIGNED_SHORT, texels.data());
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_MIRRORED_REPEAT);
  }

  // Alpha 0 is transparent, 16 and more opaque.
  void loadLattice() const {
    std::vector<RCubyte> texels;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const bool bar = x % 16 < 5 || y % 16 < 5;
        for (RCubyte c : {RCubyte(230), RCubyte(180), RCubyte(60), RCubyte(bar ? 16 : 0)}) texels.push_back(c);
      }
    }
    rcBindTexture(RC_TEXTURE_2D, m_Textures[2]);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 64, 64, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
  }

  void loadCheckers() const {
    const Picture checkers(64, 64, [](float u, float v, float *out) {
      out[0] = out[1] = out[2] = (u < 0.5f) != (v < 0.5f) ? 0.85f : 0.15f;
    });
    rcBindTexture(RC_TEXTURE_2D, m_Textures[3]);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 64, 64, 0, RC_RGB, RC_UNSIGNED_BYTE, checkers.rgb.data());
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_LINEAR);
  }

  void drawScene() const {
    static const float floor[] = {-40, -1, 10, 40, -1, 10, 40, -1, -70, -40, -1, -70};
    static const float floorTexCoords[] = {0, 0, 40, 0, 40, 40, 0, 40};
    static const float square[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static const float once[] = {0, 0, 1, 0, 1, 1, 0, 1}, threeTimes[] = {0, 0, 3, 0, 3, 3, 0, 3};
    rcStaticSceneBegin();
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    drawQuad(m_Materials[3], floor, floorTexCoords, 0);
    drawQuad(m_Materials[0], square, once, -2.3f);
    drawQuad(m_Materials[1], square, threeTimes, 0);
    drawQuad(m_Materials[2], square, once, 2.3f);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcStaticSceneEnd();
  }

  static void drawQuad(RCuint material, const float *vertices, const float *texCoords, float x) {
    rcPushMatrix();
    rcTranslatef(x, 0, 0);
    rcBindMaterial(material);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    rcDrawArrays(RC_QUADS, 0, 4);
    rcPopMatrix();
  }

  RCuint m_Textures[4] = {}, m_Materials[4] = {};
  int m_Frame = 0;
};

Tutorial g_Tutorial;
