// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A room in the evening: wood, wallpaper, a picture, a mirror, a lamp that fades with distance.
#include "common/gallery.h"

class Room : public GalleryProgram {
 public:
  Room() : GalleryProgram("Gallery: room") {}

 protected:
  void build() override {
    rcClearColor(0.05f, 0.07f, 0.15f, 1);
    camera({0.3f, 1.7f, 4.6f}, {-0.1f, 1.25f, 0}, 50);
    lamp(0, {-1.1f, 2.1f, -0.6f}, 1, {1, 0.8f, 0.5f}, 0.3f);
    rcLightf(RC_LIGHT0, RC_QUADRATIC_ATTENUATION, 0.06f);
    lamp(1, {2, 2.8f, 3}, 1, {0.3f, 0.35f, 0.5f});
    Look{.mirror = {0.07f, 0.06f, 0.05f}, .texture = load(wood())}.make();
    quad({-3, 0, 5}, {6, 0, 0}, {0, 0, -8}, 2, 3);
    Look{.texture = load(Picture(128, 128, paper))}.make();
    quad({-3, 0, -3}, {6, 0, 0}, {0, 3, 0}, 10, 5);
    quad({-3, 0, 5}, {0, 0, -8}, {0, 3, 0}, 13, 5);
    quad({3, 0, -3}, {0, 0, 8}, {0, 3, 0}, 13, 5);
    Look{.colour = {0.8f, 0.78f, 0.72f}}.make();
    quad({-3, 3, -3}, {6, 0, 0}, {0, 0, 8});
    drawBoxAt(0, 0.08f, -2.97f, 6, 0.16f, 0.05f);
    furniture();
  }

 private:
  static void paper(float u, float v, float *out) {
    const float stripe = std::fabs(u - 0.5f) < 0.18f, leaf = std::hypot(u - 0.5f, (v - 0.5f) * 0.7f) < 0.12f;
    out[0] = 0.45f + 0.1f * stripe + 0.25f * leaf, out[1] = 0.5f + 0.07f * stripe + 0.1f * leaf;
    out[2] = 0.42f + 0.05f * stripe - 0.1f * leaf;
  }

  static void furniture() {
    const RCuint timber = load(wood());
    Look{.mirror = {0.1f, 0.1f, 0.1f}, .shine = 40, .texture = timber}.make();
    drawBoxAt(-0.3f, 0.8f, -0.8f, 2.4f, 0.08f, 1.1f);
    for (float x : {-1.4f, 0.8f}) {
      for (float z : {-1.25f, -0.35f}) drawBoxAt(x, 0.38f, z, 0.09f, 0.76f, 0.09f);
    }
    drawBoxAt(1.75f, 1.6f, -2.96f, 1.5f, 1.9f, 0.06f);
    Look{.colour = {0.02f, 0.02f, 0.02f}, .mirror = {0.85f, 0.87f, 0.88f}}.make();
    quad({1.1f, 0.75f, -2.92f}, {1.3f, 0, 0}, {0, 1.7f, 0});
    Look{.texture = load(Picture(128, 128,
                                 [](float u, float v, float *out) {
                                   const float hill = v < 0.35f + 0.12f * std::sin(6 * u) ? 1.0f : 0.0f,
                                               sun = std::hypot(u - 0.7f, v - 0.7f) < 0.1f;
                                   out[0] = hill ? 0.2f : 0.9f, out[1] = hill ? 0.4f : 0.55f + 0.4f * sun,
                                   out[2] = hill ? 0.25f : 0.35f + 0.3f * v;
                                 }))}
        .make();
    quad({-2.3f, 1.3f, -2.96f}, {1.6f, 0, 0}, {0, 1.1f, 0});
    Look{.colour = {0.75f, 0.55f, 0.25f}, .mirror = {0.25f, 0.2f, 0.1f}, .shine = 60}.make();
    turned(32, 16, [](float v) {
      return Point{0.16f - 0.14f * std::sin(1.57f * v), 0.7f * v, 0};
    }).drawAt({-1.1f, 0.84f, -0.8f});
    Look{.colour = {1, 0.9f, 0.7f}}.make();
    rcDisable(RC_USE_TRANSMITTANCE_SHADOW);
    turned(32, 4, [](float v) { return Point{0.36f - 0.2f * v, 0.35f * v, 0}; }).drawAt({-1.1f, 1.55f, -0.8f});
    lightPasses(true);
    glass().make();
    turned(48, 24, [](float v) { return Point{0.12f + 0.04f * v, 0.3f * v, 0}; }).drawAt({-0.1f, 0.85f, -0.6f});
    lightPasses(false);
    Look{.colour = {0.8f, 0.2f, 0.12f}, .shine = 30}.make();
    ball(32).drawAt({0.35f, 0.97f, -0.9f}, 0.13f);
    Look{.colour = {0.55f, 0.7f, 0.15f}, .shine = 30}.make();
    ball(32).drawAt({0.6f, 0.96f, -0.65f}, 0.12f);
  }
};

Room g_Program;
