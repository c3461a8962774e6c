// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// sphere.h: a unit sphere about the origin as arrays for RC_TRIANGLES. The poles lie on the y axis, u runs
// once round from west to east (counter-clockwise seen from above), v from the south pole to the north pole.
#pragma once

#include <RC/rc.h>

#include <cmath>
#include <vector>

struct Sphere {
  std::vector<float> positions;  // 3 a vertex; of a unit sphere they are the normals too
  std::vector<float> texCoords;  // 2 a vertex

  int vertices() const { return int(positions.size() / 3); }

  // With normals and texture coordinates, in the bound material.
  void draw() const {
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, positions.data());
    rcNormalPointer(RC_FLOAT, 0, positions.data());
    rcTexCoordPointer(2, RC_FLOAT, 0, texCoords.data());
    rcDrawArrays(RC_TRIANGLES, 0, vertices());
    rcDisableClientState(RC_VERTEX_ARRAY);
    rcDisableClientState(RC_NORMAL_ARRAY);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  }

  Sphere(int around, int upwards) {
    for (int i = 0; i < upwards; ++i) {
      for (int j = 0; j < around; ++j) {
        const double u0 = double(j) / around, u1 = double(j + 1) / around;
        const double v0 = double(i) / upwards, v1 = double(i + 1) / upwards;
        if (i > 0) add(u0, v0), add(u1, v0), add(u1, v1);  // at a pole one of the two has no area
        if (i + 1 < upwards) add(u0, v0), add(u1, v1), add(u0, v1);
      }
    }
  }

 private:
  void add(double u, double v) {
    const double pi = 3.14159265358979323846;
    const double longitude = 2 * pi * u, latitude = pi * (v - 0.5);
    positions.push_back(float(std::sin(longitude) * std::cos(latitude)));
    positions.push_back(float(std::sin(latitude)));
    positions.push_back(float(std::cos(longitude) * std::cos(latitude)));
    texCoords.push_back(float(u));
    texCoords.push_back(float(v));
  }
};
