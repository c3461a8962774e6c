// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Islands: hills from noise, coloured by their height, in a sea that mirrors them.
#include "common/gallery.h"

class Islands : public GalleryProgram {
 public:
  Islands() : GalleryProgram("Gallery: islands") {}

 protected:
  void build() override {
    const float haze[] = {0.75f, 0.82f, 0.92f, 1};
    rcClearColor(haze[0], haze[1], haze[2], 1);
    camera({0, 2.4f, 11}, {0, 0.2f, 0}, 45);
    lamp(0, {-0.7f, 0.6f, 0.5f}, 0, {0.85f, 0.75f, 0.6f}, 0.4f);
    rcEnable(RC_FOG);
    rcFogf(RC_FOG_MODE, RC_EXP2);
    rcFogf(RC_FOG_DENSITY, 0.04f);
    rcFogfv(RC_FOG_COLOR, haze);
    const auto height = [](float u, float v) {
      const float hills = cloudNoise(u * 0.98f, v * 0.98f, 5), ridge = 1 - std::fabs(2 * cloudNoise(u, v, 9) - 0.97f);
      return 5.5f * (hills - 0.5f) + 0.9f * (ridge - 0.8f);
    };
    Look{.texture = load(Picture(512, 512,
                                 [&](float u, float v, float *out) {
                                   const float h = height(u, v) + 0.25f * cloudNoise(u, v, 64),
                                               rough = 0.8f + 0.4f * cloudNoise(u, v, 40);
                                   const Rgb c = h < 0.25f   ? Rgb{0.85f, 0.78f, 0.55f}
                                                 : h < 0.8f  ? Rgb{0.3f, 0.45f, 0.16f}
                                                 : h < 1.35f ? Rgb{0.4f, 0.35f, 0.3f}
                                                             : Rgb{1, 1, 1};
                                   out[0] = c.r * rough, out[1] = c.g * rough, out[2] = c.b * rough;
                                 }))}
        .make();
    Surface(256, 256, [&](float u, float v) { return Point{24 * u - 12, height(u, v), 8 - 24 * v}; }).draw();
    Look{.colour = {0.05f, 0.14f, 0.2f}, .mirror = {0.45f, 0.48f, 0.5f}}.make();
    quad({-60, 0, 20}, {120, 0, 0}, {0, 0, -90});
  }
};

Islands g_Program;
