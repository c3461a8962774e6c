// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 6: one sphere in five materials, before a wall and on a floor that they can show.
#include "RCFramework.h"
#include "common/box.h"
#include "common/pictures.h"
#include "common/sphere.h"

class Materials : public RCFramework {
 public:
  Materials() : RCFramework("Learn 6: materials", 800, 480), m_Sphere(64, 32) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.5f, 0.6f, 0.75f, 1);
    rcuPerspective(40, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(0, 2.2f, 9, 0, 0.7f, 0, 0, 1, 0);
    const float lamp[] = {-4, 7, 6, 1}, dim[] = {0.35f, 0.35f, 0.35f}, full[] = {1, 1, 1};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, lamp);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, full);
    rcLightfv(RC_LIGHT0, RC_SPECULAR, full);

    rcStaticSceneBegin();
    drawRoom();
    const float red[] = {0.8f, 0.15f, 0.1f}, dark[] = {0.04f, 0.04f, 0.05f}, white[] = {1, 1, 1};
    const float gold[] = {0.85f, 0.6f, 0.25f}, half[] = {0.5f, 0.5f, 0.5f}, most[] = {0.9f, 0.92f, 0.9f};

    ball(-4, red);  // 1: matte

    ball(-2, red);  // 2: the same with a highlight
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, white);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 40);

    ball(0, gold);  // 3: half of what is seen is mirrored, in the colour of gold
    rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, gold);

    ball(2, dark);  // 4: lets half of the light through, without bending it
    rcMaterialfv(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, half);

    ball(4, dark);  // 5: glass
    rcMaterialfv(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, most);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, 1.5f);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, white);
    rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 80);
    rcStaticSceneEnd();
    return TRUE;
  }

 private:
  // Leaves a new material bound: what is set afterwards is seen all the same, because materials go by name.
  void ball(float x, const float *colour) {
    newMaterial(colour);
    rcPushMatrix();
    rcTranslatef(x, 0.85f, 0);
    rcScalef(0.85f, 0.85f, 0.85f);
    m_Sphere.draw();
    rcPopMatrix();
  }

  // A new material is a copy of the bound one, so 0 is bound first.
  static void newMaterial(const float *colour) {
    RCuint material;
    rcBindMaterial(0);
    rcGenMaterials(1, &material);
    rcBindMaterial(material);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
  }

  static void drawRoom() {
    const Picture tiles(64, 64, [](float u, float v, float *out) {
      const float tone = (u < 0.5f) != (v < 0.5f) ? 0.85f : 0.35f;
      out[0] = tone, out[1] = 0.95f * tone, out[2] = 0.85f * tone;
    });
    const float white[] = {1, 1, 1};
    static const float floor[] = {-12, 0, 8, 12, 0, 8, 12, 0, -4, -12, 0, -4};
    static const float wall[] = {-12, 0, -4, 12, 0, -4, 12, 6, -4, -12, 6, -4};
    static const float often[] = {0, 0, 12, 0, 12, 6, 0, 6};
    RCuint texture;
    newMaterial(white);
    rcGenTextures(1, &texture);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, texture);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 64, 64, 0, RC_RGB, RC_UNSIGNED_BYTE, tiles.rgb.data());
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcTexCoordPointer(2, RC_FLOAT, 0, often);
    for (const float *quad : {floor, wall}) {
      rcVertexPointer(3, RC_FLOAT, 0, quad);
      rcDrawArrays(RC_QUADS, 0, 4);
    }
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }

  Sphere m_Sphere;
};

Materials g_Program;
