// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Appendix B: a textured cube without any light of its own: the default light shines. Two faces are drawn
// through indices, four from consecutive vertices. With the argument "figure" the cube stands as in the
// guide's picture, which the guide's listing does not give.
#include <string.h>

#include "RCFramework.h"
#include "common/pictures.h"

class Tutorial : public RCFramework {
 public:
  Tutorial() : RCFramework("Appendix B: cube", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    m_AsInFigure = m_Cmd.argc > 1 && !strcmp(m_Cmd.argv[1], "figure");
    rcSceneAllInit();
    rcClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    rcMatrixMode(RC_PROJECTION);
    rcLoadIdentity();
    rcFrustumf(-0.9622504483f, 0.9622504483f, -0.577350269f, 0.577350269f, 1, 100);
    rcuLookAt(0, 0, 1, 0, 0, 0, 0, 1, 0);
    rcGenTextures(2, m_Textures);
    rcGenMaterials(2, m_Materials);
    loadTexture(m_Textures[0], [](float u, float v, float *out) { drawRings(u, v, out); });
    loadTexture(m_Textures[1], [](float u, float v, float *out) { drawTree(u, v, out); });
    return TRUE;
  }

  BOOL OnDraw() override {
    if (IsTestMode() && ++m_Frame > 3) return FALSE;
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    if (m_AsInFigure) {
      rcTranslatef(0, 0, -3);
      rcRotatef(-m_SpinY, 0, 1, 0);
      rcRotatef(-m_SpinZ, 0, 0, 1);
    } else {
      rcTranslatef(0, 0, -6);
      rcRotatef(-m_SpinY, 1, 0, 0);
      rcRotatef(-m_SpinZ, 0, 1, 0);
    }
    drawCube();
    m_SpinY -= 3;
    m_SpinZ -= 3;
    return TRUE;
  }

 private:
  // White ground, and a picture that shows which way is up.
  static void drawRings(float u, float v, float *out) {
    const float radius = std::hypot(u - 0.5f, v - 0.4f), handle = std::hypot(u - 0.78f, v - 0.55f);
    const bool ink = radius < 0.28f || (handle > 0.1f && handle < 0.15f);
    out[0] = ink ? 0.55f : 1, out[1] = ink ? 0.25f : 1, out[2] = ink ? 0.1f : 1;
  }
  static void drawTree(float u, float v, float *out) {
    const bool crown = v > 0.35f && v < 0.9f && std::fabs(u - 0.5f) < 0.5f * (0.9f - v);
    const bool trunk = v > 0.1f && v <= 0.35f && std::fabs(u - 0.5f) < 0.06f;
    out[0] = crown ? 0.1f : trunk ? 0.4f : 1, out[1] = crown ? 0.5f : trunk ? 0.25f : 1;
    out[2] = crown ? 0.2f : trunk ? 0.1f : 1;
  }

  template <class Colour>
  static void loadTexture(RCuint name, Colour &&colour) {
    const Picture picture(128, 128, colour);
    rcBindTexture(RC_TEXTURE_2D, name);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, picture.width, picture.height, 0, RC_RGB, RC_UNSIGNED_BYTE,
                 picture.rgb.data());
  }

  void bindFace(int face) const {
    rcBindMaterial(m_Materials[face % 2]);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, m_Textures[face % 2]);
  }

  void drawCube() const {
    static const float corners[] = {-1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1, -1, -1, -1, -1, 1, -1, 1, 1, -1, 1, -1, -1};
    static const float cornerTexCoords[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0};
    static const RCubyte quads[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static const float vertices[] = {-1, 1,  -1, -1, 1,  1,  1,  1,  1, 1,  1,  -1,   // top
                                     -1, -1, -1, 1,  -1, -1, 1,  -1, 1, -1, -1, 1,    // bottom
                                     1,  -1, -1, 1,  1,  -1, 1,  1,  1, 1,  -1, 1,    // right
                                     -1, -1, -1, -1, -1, 1,  -1, 1,  1, -1, 1,  -1};  // left
    static const float texCoords[] = {0, 1, 0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0, 1, 0,
                                      1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1};
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, corners);
    rcTexCoordPointer(2, RC_FLOAT, 0, cornerTexCoords);
    for (int face = 0; face < 2; ++face) {
      bindFace(face);
      rcDrawElements(RC_TRIANGLE_FAN, 4, RC_UNSIGNED_BYTE, &quads[4 * face]);
    }
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
    for (int face = 0; face < 4; ++face) {
      bindFace(face);
      rcDrawArrays(RC_TRIANGLE_FAN, 4 * face, 4);
    }
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  }

  RCuint m_Textures[2] = {}, m_Materials[2] = {};
  float m_SpinY = -10, m_SpinZ = -30;
  bool m_AsInFigure = false;
  int m_Frame = 0;
};

Tutorial g_Tutorial;
