// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A window of coloured glass throws its colours on the floor: shadows that are tinted.
#include "common/gallery.h"

class Window : public GalleryProgram {
 public:
  Window() : GalleryProgram("Gallery: window") {}

 protected:
  void build() override {
    rcClearColor(0.75f, 0.85f, 0.95f, 1);
    camera({2.6f, 1.8f, 5.2f}, {-0.4f, 1.3f, 0}, 50);
    lamp(0, {-3, 6, -9}, 1, {1, 0.95f, 0.85f}, 0.35f);
    lamp(1, {4, 3.5f, 6}, 1, {0.35f, 0.33f, 0.3f});
    Look{.colour = {0.75f, 0.72f, 0.68f}, .mirror = {0.06f, 0.06f, 0.06f}}.make();
    quad({-5, 0, 7}, {10, 0, 0}, {0, 0, -9});
    Look{.colour = {0.7f, 0.68f, 0.62f}}.make();
    drawBoxAt(-3.4f, 2, -2, 3.2f, 4, 0.4f);
    drawBoxAt(3.4f, 2, -2, 3.2f, 4, 0.4f);
    drawBoxAt(0, 0.2f, -2, 3.6f, 0.4f, 0.4f);
    drawBoxAt(0, 3.9f, -2, 3.6f, 0.4f, 0.4f);
    quad({-5, 0, 7}, {0, 0, -9}, {0, 4.1f, 0});
    Look{.colour = {0.1f, 0.1f, 0.1f}}.make();
    for (int i = 0; i <= 6; ++i) drawBoxAt(-1.8f + 0.6f * float(i), 2.05f, -2, 0.05f, 3.3f, 0.08f);
    for (int j = 0; j <= 5; ++j) drawBoxAt(0, 0.4f + 0.66f * float(j), -2, 3.6f, 0.05f, 0.08f);
    lightPasses(true);
    const Rgb colours[] = {
        {0.9f, 0.15f, 0.1f}, {0.95f, 0.7f, 0.1f}, {0.1f, 0.55f, 0.25f}, {0.1f, 0.3f, 0.85f}, {0.65f, 0.2f, 0.7f}};
    for (const Rgb &colour : colours) {
      Look{.colour = {colour.r * 0.1f, colour.g * 0.1f, colour.b * 0.1f}, .clear = colour}.make();
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 5; ++j) {
          if (&colours[(i + 2 * j + i * j) % 5] != &colour) continue;
          quad({-1.8f + 0.6f * float(i), 0.4f + 0.66f * float(j), -2}, {0.6f, 0, 0}, {0, 0.66f, 0});
        }
      }
    }
    lightPasses(false);
    Look{.colour = {0.85f, 0.83f, 0.8f}}.make();
    ball(48).drawAt({0.8f, 0.6f, 1.2f}, 0.6f);
  }
};

Window g_Program;
