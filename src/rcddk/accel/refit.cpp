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

}  // namespace

double costOf(const Accel &accel) {
  double areas = 0;
  for (const BvhNode8 &node : accel.bvhNodes) {
    for (uint32_t i = 0; i < BvhNode8::kWidth && node.child[i] != 0; ++i) {
      areas += intersection(node.box(i), accel.core).halfArea();
    }
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
