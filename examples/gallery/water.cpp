// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A pool: waves run over tiles, bend what lies below and mirror the sky. A film.
#include "common/gallery.h"

class Water : public GalleryProgram {
 public:
  Water() : GalleryProgram("Gallery: water") {}

 protected:
  void build() override {
    rcClearColor(0.5f, 0.7f, 0.95f, 1);
    camera({0, 3.4f, 6.5f}, {0, -0.5f, 0}, 42);
    lamp(0, {-3, 8, 2}, 1, {0.85f, 0.82f, 0.75f}, 0.45f);
    const RCuint tiles = load(Picture(128, 128, [](float u, float v, float *out) {
      const float x = u * 4 - std::floor(u * 4), y = v * 4 - std::floor(v * 4);
      const float tone = 0.8f + 0.2f * gridNoise(int(u * 4), int(v * 4));
      const bool joint = x < 0.07f || y < 0.07f;
      out[0] = joint ? 0.85f : 0.25f * tone, out[1] = joint ? 0.9f : 0.6f * tone, out[2] = joint ? 0.9f : 0.75f * tone;
    }));
    Look{.texture = tiles}.make();
    quad({-4, -1.5f, 3}, {8, 0, 0}, {0, 0, -6}, 4, 3);
    quad({-4, -1.5f, -3}, {8, 0, 0}, {0, 2.0f, 0}, 4, 1);
    quad({-4, -1.5f, 3}, {0, 0, -6}, {0, 2.0f, 0}, 3, 1);
    quad({4, -1.5f, -3}, {0, 0, 6}, {0, 2.0f, 0}, 3, 1);
    Look{.colour = {0.85f, 0.8f, 0.72f}}.make();
    drawBoxAt(0, 0.45f, -3.6f, 9.6f, 0.3f, 1.2f);
    for (float x : {-4.6f, 4.6f}) drawBoxAt(x, 0.45f, 0, 1.2f, 0.3f, 6);
    Look{.colour = {0.9f, 0.25f, 0.15f}, .shine = 40}.make();
    ball(48).drawAt({-1.2f, -1, -0.3f}, 0.5f);
    Look{.colour = {0.95f, 0.8f, 0.2f}, .shine = 40}.make();
    ball(48).drawAt({1.7f, 0.25f, -1}, 0.55f);
    m_Water = Look{.colour = {0.02f, 0.05f, 0.06f},
                   .mirror = {0.18f, 0.18f, 0.18f},
                   .clear = {0.72f, 0.8f, 0.82f},
                   .index = 1.33f,
                   .shine = 120}
                  .make();
  }

  void move(float t) override {
    const Surface waves(160, 120, [=](float u, float v) {
      const float x = 8 * u - 4, z = 3 - 6 * v, r = std::hypot(x - 1.7f, z + 1);
      const float y =
          0.035f * std::sin(4 * x + 2 * t) * std::cos(3 * z - t) + 0.07f * std::sin(7 * r - 6 * t) / (1 + r);
      return Point{x, y, z};
    });
    rcBindMaterial(m_Water);
    lightPasses(true);
    waves.draw();
    lightPasses(false);
  }

 private:
  RCuint m_Water = 0;
};

Water g_Program;
