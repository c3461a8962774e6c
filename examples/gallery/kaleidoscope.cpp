// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A kaleidoscope: three mirrors and a handful of coloured stones. A film.
#include "common/gallery.h"

class Kaleidoscope : public GalleryProgram {
 public:
  Kaleidoscope() : GalleryProgram("Gallery: kaleidoscope"), m_Stone(ball(24)) {}

 protected:
  void build() override {
    SetDepthBounce(14);
    rcClearColor(0.9f, 0.88f, 0.8f, 1);
    camera({0, 0.05f, 6}, {0, 0, 0}, 62);
    lamp(0, {0, 0, 5.5f}, 1, {0.75f, 0.75f, 0.75f}, 0.45f);
    Look{.colour = {0.01f, 0.01f, 0.01f}, .mirror = {0.93f, 0.93f, 0.94f}}.make();
    for (int i = 0; i < 3; ++i) {
      rcPushMatrix();
      rcRotatef(120 * float(i), 0, 0, 1);
      quad({-1.74f, -1, 5.9f}, {3.48f, 0, 0}, {0, 0, -6.1f});
      rcPopMatrix();
    }
    for (int i = 0; i < kStones; ++i) {
      const float hue = 2 * kPi * gridNoise(i, 1);
      const Rgb colour{0.5f + 0.45f * std::cos(hue), 0.5f + 0.45f * std::cos(hue - 2.1f),
                       0.5f + 0.45f * std::cos(hue + 2.1f)};
      m_Materials[i] = Look{.colour = colour, .mirror = {0.08f, 0.08f, 0.08f}, .shine = 40}.make();
    }
  }

  void move(float t) override {
    for (int i = 0; i < kStones; ++i) {
      const float angle = 0.3f * t + 2 * kPi * gridNoise(i, 2), r = 1.3f * std::sqrt(gridNoise(i, 3));
      rcBindMaterial(m_Materials[i]);
      rcPushMatrix();
      rcTranslatef(r * std::cos(angle), r * std::sin(angle), -0.1f * float(i % 4));
      rcRotatef(60 * t + 40 * float(i), 0, 0, 1);
      rcScalef(0.16f + 0.2f * gridNoise(i, 4), 0.1f + 0.08f * gridNoise(i, 5), 0.1f);
      i % 3 ? m_Stone.draw() : drawBox(2, 2, 2);
      rcPopMatrix();
    }
  }

 private:
  static constexpr int kStones = 22;
  Surface m_Stone;
  RCuint m_Materials[kStones] = {};
};

Kaleidoscope g_Program;
