// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Learn 7: one ring, submitted in four ways: vertices in a row, indices, a strip, and a buffer object.
#include <cmath>
#include <vector>

#include "RCFramework.h"

class Geometry : public RCFramework {
 public:
  Geometry() : RCFramework("Learn 7: geometry", 800, 480) {}

 protected:
  BOOL OnIntialize() override {
    rcClearColor(0.1f, 0.12f, 0.16f, 1);
    rcuPerspective(40, float(Width()) / float(Height()), 0.1f, 100);
    rcuLookAt(0, 1.5f, 7, 0, 0, 0, 0, 1, 0);
    const float lamp[] = {2, 4, 5, 1}, dim[] = {0.3f, 0.3f, 0.3f}, bright[] = {0.8f, 0.8f, 0.8f};
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_POSITION, lamp);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, bright);

    makeRing();
    rcStaticSceneBegin();
    rcEnableClientState(RC_VERTEX_ARRAY);
    inRow(-2.7f, 0.9f, 0.4f, 0.2f);
    byIndices(-0.9f, 0.9f, 0.8f, 0.3f);
    asStrip(0.9f, 0.3f, 0.7f, 0.4f);
    fromBuffer(2.7f, 0.3f, 0.5f, 0.9f);
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcStaticSceneEnd();
    return TRUE;
  }

 private:
  static const int kSegments = 24;

  // Vertices 2 i and 2 i + 1: the lower and the upper one at an angle; the first two come again at the end.
  void makeRing() {
    for (int i = 0; i <= kSegments; ++i) {
      const float angle = 6.2831853f * float(i) / kSegments;
      for (float y : {-0.25f, 0.25f}) m_Ring.insert(m_Ring.end(), {0.7f * std::sin(angle), y, 0.7f * std::cos(angle)});
    }
    for (RCushort i = 0; i < 2 * kSegments; i += 2) {
      for (int corner : {0, 2, 3, 0, 3, 1}) m_Indices.push_back(RCushort(i + corner));
    }
  }

  void inRow(float x, float red, float green, float blue) const {
    std::vector<float> corners;
    for (RCushort i : m_Indices) corners.insert(corners.end(), &m_Ring[3 * i], &m_Ring[3 * i] + 3);
    place(x, red, green, blue);
    rcVertexPointer(3, RC_FLOAT, 0, corners.data());
    rcDrawArrays(RC_TRIANGLES, 0, RCsizei(corners.size() / 3));
    rcPopMatrix();
  }

  void byIndices(float x, float red, float green, float blue) const {
    place(x, red, green, blue);
    rcVertexPointer(3, RC_FLOAT, 0, m_Ring.data());
    rcDrawElements(RC_TRIANGLES, RCsizei(m_Indices.size()), RC_UNSIGNED_SHORT, m_Indices.data());
    rcPopMatrix();
  }

  void asStrip(float x, float red, float green, float blue) const {
    place(x, red, green, blue);
    rcVertexPointer(3, RC_FLOAT, 0, m_Ring.data());
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 2 * kSegments + 2);
    rcPopMatrix();
  }

  void fromBuffer(float x, float red, float green, float blue) const {
    RCuint buffer;
    rcGenBuffers(1, &buffer);
    rcBindBuffer(RC_ARRAY_BUFFER, buffer);
    rcBufferData(RC_ARRAY_BUFFER, RCsizeiptr(m_Ring.size() * sizeof(float)), m_Ring.data(), RC_STATIC_DRAW);
    place(x, red, green, blue);
    rcVertexPointer(3, RC_FLOAT, 0, nullptr);  // an offset now: the beginning of the buffer
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 2 * kSegments + 2);
    rcPopMatrix();
    rcBindBuffer(RC_ARRAY_BUFFER, 0);
  }

  static void place(float x, float red, float green, float blue) {
    RCuint material;
    rcGenMaterials(1, &material);
    rcBindMaterial(material);
    rcColor4f(red, green, blue, 1);
    rcPushMatrix();
    rcTranslatef(x, 0, 0);
    rcRotatef(20, 1, 0, 0.3f);
  }

  std::vector<float> m_Ring;
  std::vector<RCushort> m_Indices;
};

Geometry g_Program;
