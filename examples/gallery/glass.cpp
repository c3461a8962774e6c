// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Three balls: glass, gold and green glass. Light falls through them and is tinted.
#include "common/gallery.h"

class Glass : public GalleryProgram {
 public:
  Glass() : GalleryProgram("Gallery: glass") {}

 protected:
  void build() override {
    rcClearColor(0.55f, 0.68f, 0.85f, 1);
    camera({0, 2.2f, 7.5f}, {0, 0.85f, 0}, 38);
    lamp(0, {-4, 7, 3}, 1, {0.9f, 0.88f, 0.8f}, 0.4f);
    lamp(1, {5, 4, 4}, 1, {0.25f, 0.25f, 0.3f});
    Look{.texture = load(checkers({0.9f, 0.88f, 0.82f}, {0.25f, 0.3f, 0.38f}))}.make();
    quad({-30, 0, 12}, {60, 0, 0}, {0, 0, -60}, 30, 30);
    const Surface sphere = ball(96);
    Look{.colour = {0.3f, 0.2f, 0.05f}, .mirror = {0.75f, 0.55f, 0.25f}, .shine = 60}.make();
    sphere.drawAt({1.0f, 1.1f, -1.6f}, 1.1f);
    lightPasses(true);
    glass().make();
    sphere.drawAt({-1.3f, 1, 0});
    glass({0.35f, 0.9f, 0.5f}).make();
    sphere.drawAt({1.9f, 0.7f, 0.9f}, 0.7f);
    lightPasses(false);
  }
};

Glass g_Program;
