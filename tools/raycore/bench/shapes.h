// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shapes.h: triangles of simple bodies, for scenes that need no file.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace rc::tool {

inline constexpr float kPi = 3.14159265f;

// A grid over u, v = 0 ... 1, with normals that follow the surface and coordinates (u, v).
Primitive surfaceOf(int columns, int rows, const std::function<Vec3(float u, float v)> &point);

Primitive sphere(const Vec3 &centre, float radius, int columns, int rows);
Primitive block(const Vec3 &low, const Vec3 &high, float turn = 0);
// corner and two sides; its front looks along their cross product.
Primitive panel(const Vec3 &corner, const Vec3 &across, const Vec3 &up);

void append(Primitive &to, const Primitive &from);

// Adds a mesh of one primitive, and a node for it; the node's number.
int addBody(Scene &scene, Primitive primitive, int material);
int addMaterial(Scene &scene, const std::string &name, const Vec3 &linear, float metallic = 0, float roughness = 1);

// Numbers 0 ... 1, the same ones on every machine. [Knuth's MMIX generator]
class Random {
 public:
  float next() {
    mState = mState * 6364136223846793005u + 1442695040888963407u;
    return float(mState >> 40) / float(1 << 24);
  }

 private:
  uint64_t mState = 1;
};

}  // namespace rc::tool
