// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// box.h: a box about the origin as quads, in the bound material; v and u run over each side once.
#pragma once

#include <RC/rc.h>

// Sizes along x, y and z.
inline void drawBox(float width, float height, float depth) {
  static const float corners[] = {-1, -1, 1,  1,  -1, 1,  1,  1,  1,  -1, 1,  1,   // front
                                  1,  -1, -1, -1, -1, -1, -1, 1,  -1, 1,  1,  -1,  // back
                                  1,  -1, 1,  1,  -1, -1, 1,  1,  -1, 1,  1,  1,   // right
                                  -1, -1, -1, -1, -1, 1,  -1, 1,  1,  -1, 1,  -1,  // left
                                  -1, 1,  1,  1,  1,  1,  1,  1,  -1, -1, 1,  -1,  // top
                                  -1, -1, -1, 1,  -1, -1, 1,  -1, 1,  -1, -1, 1};  // bottom
  static const float side[] = {0, 0, 1, 0, 1, 1, 0, 1};
  float texCoords[48];
  for (int i = 0; i < 48; ++i) texCoords[i] = side[i % 8];
  rcPushMatrix();
  rcScalef(width / 2, height / 2, depth / 2);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, corners);
  rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
  rcDrawArrays(RC_QUADS, 0, 24);
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  rcDisableClientState(RC_VERTEX_ARRAY);
  rcPopMatrix();
}

// The same with its middle at (x, y, z).
inline void drawBoxAt(float x, float y, float z, float width, float height, float depth) {
  rcPushMatrix();
  rcTranslatef(x, y, z);
  drawBox(width, height, depth);
  rcPopMatrix();
}
