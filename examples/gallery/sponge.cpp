// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Menger's sponge at its third step: 8000 cubes, in fog.
#include "common/gallery.h"

class Sponge : public GalleryProgram {
 public:
  Sponge() : GalleryProgram("Gallery: sponge") {}

 protected:
  void build() override {
    const float haze[] = {0.72f, 0.6f, 0.5f, 1};
    rcClearColor(haze[0], haze[1], haze[2], 1);
    camera({1.1f, 0.75f, 1.45f}, {-0.1f, -0.08f, -0.2f}, 52);
    lamp(0, {3, 4, 2.2f}, 1, {1, 0.85f, 0.65f}, 0.3f);
    rcEnable(RC_FOG);
    rcFogf(RC_FOG_MODE, RC_EXP2);
    rcFogf(RC_FOG_DENSITY, 0.22f);
    rcFogfv(RC_FOG_COLOR, haze);
    Look{.colour = {0.75f, 0.62f, 0.5f}}.make();
    split(0, 0, 0, 1.6f, 3);
    Look{.colour = {0.1f, 0.15f, 0.18f}, .mirror = {0.5f, 0.5f, 0.5f}}.make();
    quad({-20, -0.81f, 20}, {40, 0, 0}, {0, 0, -40});
  }

 private:
  static void split(float x, float y, float z, float size, int steps) {
    if (steps == 0) return drawBoxAt(x, y, z, size, size, size);
    const float third = size / 3;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        for (int k = -1; k <= 1; ++k) {
          if ((i == 0) + (j == 0) + (k == 0) >= 2) continue;
          split(x + third * float(i), y + third * float(j), z + third * float(k), third, steps - 1);
        }
      }
    }
  }
};

Sponge g_Program;
