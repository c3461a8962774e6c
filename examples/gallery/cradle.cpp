// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Newton's cradle: five balls of steel before a checkered wall. A film.
#include "common/gallery.h"

class Cradle : public GalleryProgram {
 public:
  Cradle() : GalleryProgram("Gallery: cradle"), m_Ball(ball(64)) {}

 protected:
  void build() override {
    rcClearColor(0.35f, 0.42f, 0.5f, 1);
    camera({1.5f, 2.3f, 6.8f}, {0, 1.35f, 0}, 42);
    lamp(0, {-3, 6, 5}, 1, {0.85f, 0.82f, 0.78f}, 0.35f);
    lamp(1, {4, 5, 2}, 1, {0.25f, 0.28f, 0.35f});
    Look{.mirror = {0.15f, 0.15f, 0.15f}, .texture = load(wood())}.make();
    quad({-9, 0, 7}, {18, 0, 0}, {0, 0, -12}, 4, 4);
    Look{.texture = load(checkers({0.85f, 0.82f, 0.75f}, {0.6f, 0.25f, 0.2f}))}.make();
    quad({-9, 0, -4}, {18, 0, 0}, {0, 7, 0}, 9, 3.5f);
    Look{.colour = {0.2f, 0.2f, 0.22f}, .mirror = {0.2f, 0.2f, 0.2f}, .shine = 40}.make();
    for (float z : {-0.8f, 0.8f}) {
      drawBoxAt(0, 3, z, 4.4f, 0.1f, 0.1f);
      for (float x : {-2.15f, 2.15f}) drawBoxAt(x, 1.5f, z, 0.1f, 3, 0.1f);
    }
    drawBoxAt(0, 0.06f, 0, 4.8f, 0.12f, 2.2f);
    m_Steel = Look{.colour = {0.08f, 0.08f, 0.09f}, .mirror = {0.72f, 0.72f, 0.75f}, .shine = 90}.make();
    m_Thread = Look{.colour = {0.85f, 0.85f, 0.8f}}.make();
  }

  void move(float t) override {
    const float swing = 38 * std::cos(kPi * t + 0.4f);
    for (int i = 0; i < 5; ++i) {
      const float angle = i == 0 && swing < 0 ? swing : i == 4 && swing > 0 ? swing : 0;
      rcPushMatrix();
      rcTranslatef(0.7f * float(i - 2), 3, 0);
      rcRotatef(angle, 0, 0, 1);
      rcBindMaterial(m_Steel);
      m_Ball.drawAt({0, -2.1f, 0}, 0.35f);
      rcBindMaterial(m_Thread);
      for (float side : {-1.0f, 1.0f}) {
        rcPushMatrix();
        rcTranslatef(0, -0.9f, 0.4f * side);
        rcRotatef(side * -24, 1, 0, 0);
        drawBox(0.02f, 2.0f, 0.02f);
        rcPopMatrix();
      }
      rcPopMatrix();
    }
  }

 private:
  Surface m_Ball;
  RCuint m_Steel = 0, m_Thread = 0;
};

Cradle g_Program;
