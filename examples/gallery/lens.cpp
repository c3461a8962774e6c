// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A lens over a printed page: two caps of glass spheres enlarge what lies below.
#include "common/gallery.h"

class Lens : public GalleryProgram {
 public:
  Lens() : GalleryProgram("Gallery: lens") {}

 protected:
  void build() override {
    rcClearColor(0.2f, 0.16f, 0.14f, 1);
    camera({0.4f, 5.2f, 3.6f}, {0, 0, 0.1f}, 40);
    lamp(0, {-3, 7, -2}, 1, {0.75f, 0.72f, 0.65f}, 0.5f);
    Look{.texture = load(wood())}.make();
    quad({-8, -0.02f, 6}, {16, 0, 0}, {0, 0, -12}, 4, 4);
    Look{.texture = load(Picture(512, 512, page))}.make();
    quad({-2.3f, 0, 1.9f}, {4.6f, 0, 0}, {0, 0, -3.8f});
    Look{.colour = {0.5f, 0.38f, 0.15f}, .mirror = {0.35f, 0.28f, 0.12f}, .shine = 50}.make();
    const Surface rim(96, 16, [](float u, float v) {
      const float r = 1.12f + 0.08f * std::cos(2 * kPi * v);
      return Point{r * std::sin(2 * kPi * u), 0.1f * std::sin(2 * kPi * v), r * std::cos(2 * kPi * u)};
    });
    rim.drawAt({-0.2f, 0.75f, 0.2f});
    Look{.colour = {0.25f, 0.12f, 0.06f}, .shine = 30}.make();
    rcPushMatrix();
    rcTranslatef(-0.2f, 0.75f, 0.2f);
    rcRotatef(-35, 0, 1, 0);
    drawBoxAt(2.05f, 0, 0, 1.7f, 0.18f, 0.2f);
    rcPopMatrix();
    lightPasses(true);
    glass({0.95f, 0.97f, 0.97f}).make();
    const float side[] = {1, -1};
    for (float s : side) {
      Surface(64, 24, [=](float u, float v) {
        const float angle = s > 0 ? -2 * kPi * u : 2 * kPi * u, r = 1.08f * std::max(v, 1e-4f);
        return Point{r * std::sin(angle), s * 0.35f * (1 - v * v), r * std::cos(angle)};
      }).drawAt({-0.2f, 0.75f, 0.2f});
    }
    lightPasses(false);
  }

 private:
  // Lines of invented writing.
  static void page(float u, float v, float *out) {
    const float line = v * 22, word = gridNoise(int(u * 26), int(line) * 7), y = line - std::floor(line);
    const bool margin = u < 0.08f || u > 0.92f || v < 0.06f || v > 0.94f;
    const bool ink = !margin && word > 0.22f && y > 0.25f && y < 0.72f && smoothNoise(u * 150, line * 9, 512) > 0.48f;
    const float tone = ink ? 0.12f : 0.93f - 0.05f * cloudNoise(u, v, 4);
    out[0] = tone, out[1] = tone * 0.98f, out[2] = tone * 0.9f;
  }
};

Lens g_Program;
