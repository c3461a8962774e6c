// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A hall of mirrors: two facing walls show each other, up to the last bounce.
#include "common/gallery.h"

class Mirrors : public GalleryProgram {
 public:
  Mirrors() : GalleryProgram("Gallery: mirrors") {}

 protected:
  void build() override {
    SetDepthBounce(14);
    rcClearColor(0.02f, 0.02f, 0.03f, 1);
    camera({-2.1f, 1.7f, 2.2f}, {2.3f, 1.0f, -1.1f}, 58);
    lamp(0, {0, 3.6f, 0}, 1, {0.8f, 0.75f, 0.65f}, 0.3f);
    lamp(1, {-1.5f, 2, 2.5f}, 1, {0.2f, 0.25f, 0.35f});
    Look{.mirror = {0.12f, 0.12f, 0.12f}, .texture = load(checkers({0.75f, 0.7f, 0.6f}, {0.35f, 0.1f, 0.1f}))}.make();
    quad({-2.5f, 0, 4}, {5, 0, 0}, {0, 0, -8}, 6, 10);
    Look{.colour = {0.02f, 0.02f, 0.02f}, .mirror = {0.86f, 0.9f, 0.88f}}.make();
    quad({-2.45f, 0.15f, -4}, {0, 0, 8}, {0, 3.4f, 0});
    quad({2.45f, 0.15f, 4}, {0, 0, -8}, {0, 3.4f, 0});
    Look{.colour = {0.75f, 0.6f, 0.35f}, .shine = 30}.make();
    for (float x : {-2.5f, 2.5f}) {
      for (float y : {0.075f, 3.65f}) drawBoxAt(x, y, 0, 0.2f, 0.2f, 8);
    }
    Look{.colour = {0.3f, 0.28f, 0.3f}}.make();
    quad({-2.5f, 0, -4}, {5, 0, 0}, {0, 4, 0});
    quad({-2.5f, 4, -4}, {5, 0, 0}, {0, 0, 8});
    const Surface vase = turned(64, 48, [](float v) {
      return Point{0.32f + 0.16f * std::sin(5.2f * v) - 0.18f * v, 1.2f * v, 0};
    });
    Look{.colour = {0.15f, 0.3f, 0.65f}, .mirror = {0.15f, 0.15f, 0.15f}, .shine = 50}.make();
    vase.drawAt({0.5f, 0.5f, -0.4f});
    Look{.colour = {0.8f, 0.75f, 0.65f}}.make();
    drawBoxAt(0.5f, 0.25f, -0.4f, 0.9f, 0.5f, 0.9f);
  }
};

Mirrors g_Program;
