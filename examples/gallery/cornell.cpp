// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The guide's Cornell box with other blocks: a mirror and a ball of glass.
#include "common/cornell.h"

#include "common/gallery.h"

class Cornell : public GalleryProgram {
 public:
  Cornell() : GalleryProgram("Gallery: Cornell box of glass and mirrors") {}

 protected:
  void build() override {
    rcClearColor(0.2f, 0.24f, 0.3f, 1);
    camera({27.8f, 27.3f, -80}, {27.8f, 27.3f, 0}, 37);
    for (int i = 0; i < 4; ++i) {
      lamp(i, {i % 2 ? 34.3f : 21.3f, 54.8f, i / 2 ? 33.2f : 22.7f}, 1, {0.22f, 0.21f, 0.18f}, 0.07f);
    }
    wall(kLeftWall, {0.75f, 0.08f, 0.06f});
    wall(kRightWall, {0.1f, 0.45f, 0.12f});
    for (const float *white : {kFloor, kCeiling, kBackWall}) wall(white, {0.9f, 0.88f, 0.84f});
    Look{.colour = {0.05f, 0.05f, 0.05f}, .mirror = {0.88f, 0.88f, 0.9f}}.make();
    triangles(kTallBlock, 30);
    lightPasses(true);
    glass().make();
    ball(96).drawAt({17, 9, 15}, 9);
    lightPasses(false);
    Look{.colour = {0.7f, 0.5f, 0.15f}, .mirror = {0.3f, 0.22f, 0.08f}, .shine = 50}.make();
    ball(64).drawAt({33, 4.5f, 8}, 4.5f);
  }

 private:
  static void wall(const float *corners, Rgb colour) {
    Look{.colour = colour}.make();
    triangles(corners, 6);
  }
  static void triangles(const float *corners, int count) {
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, corners);
    rcDrawArrays(RC_TRIANGLES, 0, count);
    rcDisableClientState(RC_VERTEX_ARRAY);
  }
};

Cornell g_Program;
