// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// refit.cpp: a BVH for triangles that have moved: the same tree with new boxes, and how good it still is.
// Wald, Boulos, Shirley: "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume Hierarchies", TOG 26(1), 2007.
#include "rcddk/accel/bvh_parts.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;

constexpr double kWorstGrowth = 1.3;  // of the cost, against the tree as built: beyond, building anew pays

bool isChild(const BvhNode8 &node, uint32_t i) { return node.planes[0][0][i] <= node.planes[0][1][i]; }

double halfAreaOf(double x, double y, double z) { return x * y + y * z + z * x; }

// Of what lies in the core.
double halfAreaOf(const BvhNode8 &node, uint32_t i, const Bounds &core) {
  double size[3];
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = double(std::min(node.planes[axis][1][i], core.upper[axis])) -
                 double(std::max(node.planes[axis][0][i], core.lower[axis]));
    if (size[axis] < 0) return 0;
  }
  return halfAreaOf(size[0], size[1], size[2]);
}

}  // namespace

double costOf(const Accel &accel) {
  double areas = 0;
  for (const BvhNode8 &node : accel.bvhNodes) {
    for (uint32_t i = 0; i < BvhNode8::kWidth && isChild(node, i); ++i) areas += halfAreaOf(node, i, accel.core);
  }
  return areas / std::max(accel.core.halfArea(), 1e-300);
}

bool refit(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  if (accel.kind != AccelKind::Bvh || triangles.empty() || accel.triangles != triangles.size()) return false;
  fit(triangles, workers, accel);
  sampleTriangles(triangles, accel);
  return costOf(accel) <= kWorstGrowth * accel.builtCost;
}

}  // namespace rc::ddk
