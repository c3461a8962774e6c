// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Five linked rings of metal over a dark mirror.
#include "common/gallery.h"

class Rings : public GalleryProgram {
 public:
  Rings() : GalleryProgram("Gallery: rings") {}

 protected:
  void build() override {
    rcClearColor(0.72f, 0.78f, 0.88f, 1);
    camera({0, 2.6f, 8}, {0, 0.9f, 0}, 40);
    lamp(0, {-5, 8, 6}, 1, {0.8f, 0.8f, 0.8f}, 0.35f);
    lamp(1, {6, 3, 3}, 1, {0.4f, 0.4f, 0.5f});
    Look{.colour = {0.12f, 0.13f, 0.16f}, .mirror = {0.35f, 0.36f, 0.38f}}.make();
    quad({-40, -0.35f, 20}, {80, 0, 0}, {0, 0, -80});
    const Surface ring(160, 48, [](float u, float v) {
      const float a = 2 * kPi * u, b = 2 * kPi * v, r = 1 + 0.17f * std::cos(b);
      return Point{r * std::sin(a), r * std::cos(a), -0.17f * std::sin(b)};
    });
    const Rgb metals[] = {
        {0.75f, 0.55f, 0.25f}, {0.7f, 0.7f, 0.72f}, {0.72f, 0.42f, 0.3f}, {0.7f, 0.7f, 0.72f}, {0.75f, 0.55f, 0.25f}};
    for (int i = 0; i < 5; ++i) {
      const Rgb &m = metals[i];
      Look{.colour = {m.r * 0.4f, m.g * 0.4f, m.b * 0.4f}, .mirror = {m.r * 0.8f, m.g * 0.8f, m.b * 0.8f}, .shine = 50}
          .make();
      rcPushMatrix();
      rcTranslatef(-2.6f + 1.3f * float(i), i % 2 ? 0.85f : 1.05f, 0);
      rcRotatef(i % 2 ? 55.0f : -35.0f, 0, 1, 0.15f);
      ring.draw();
      rcPopMatrix();
    }
  }
};

Rings g_Program;
