// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// refit.cpp: a BVH for triangles that have moved: the same tree with new boxes, from the leaves up.
// Wald, Boulos, Shirley: "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume Hierarchies", TOG 26(1), 2007.
#include "rcddk/accel/bvh_parts.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

constexpr size_t kNodesATask = 256;
constexpr double kWorstGrowth = 1.3;  // of the cost, against the tree as built: beyond, building anew pays

bool isChild(const BvhNode8 &node, uint32_t i) { return node.planes[0][0][i] <= node.planes[0][1][i]; }

// Moves the triangles of a block and returns their box.
Bounds moveBlock(TriangleBlock4 &block, std::span<const HotTriangle> triangles) {
  Bounds box;
  for (uint32_t lane = 0; lane < TriangleBlock4::kWidth; ++lane) {
    const uint32_t primitive = block.primitive[lane];
    const HotTriangle &triangle = triangles[block.primitive[primitive == TriangleBlock4::kNone ? 0 : lane]];
    setLane(block, lane, triangle);
    const float margin = boxMargin(triangle);
    box.add(glm::min(triangle.v0, glm::min(triangle.v1, triangle.v2)) - margin);
    box.add(glm::max(triangle.v0, glm::max(triangle.v1, triangle.v2)) + margin);
  }
  return box;
}

Bounds boxOf(const BvhNode8 &node) {
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      box.lower[axis] = std::min(box.lower[axis], node.planes[axis][0][i]);
      box.upper[axis] = std::max(box.upper[axis], node.planes[axis][1][i]);
    }
  }
  return box;
}

double halfAreaOf(const BvhNode8 &node, uint32_t i) {
  const double x = double(node.planes[0][1][i]) - node.planes[0][0][i];
  const double y = double(node.planes[1][1][i]) - node.planes[1][0][i];
  const double z = double(node.planes[2][1][i]) - node.planes[2][0][i];
  return x * y + y * z + z * x;
}

}  // namespace

double costOf(const Accel &accel) {
  double areas = 0;
  for (const BvhNode8 &node : accel.bvhNodes) {
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      if (isChild(node, i)) areas += halfAreaOf(node, i);
    }
  }
  return areas / std::max(accel.bounds.halfArea(), 1e-300);
}

bool refit(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  if (accel.kind != AccelKind::Bvh || triangles.empty() || accel.triangles != triangles.size()) return false;
  std::vector<BvhNode8> &nodes = accel.bvhNodes;
  workers.forEach((nodes.size() + kNodesATask - 1) / kNodesATask, [&](size_t task, int) {
    for (size_t n = task * kNodesATask; n < std::min(nodes.size(), (task + 1) * kNodesATask); ++n) {
      for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
        const uint32_t child = nodes[n].child[i];
        if (!(child & BvhNode8::kLeaf)) continue;
        setChild(nodes[n], i, moveBlock(accel.blocks[child & ~BvhNode8::kLeaf], triangles), child);
      }
    }
  });
  // Children lie behind their parents.
  for (size_t n = nodes.size(); n-- > 0;) {
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const uint32_t child = nodes[n].child[i];
      if (child != 0 && !(child & BvhNode8::kLeaf)) setChild(nodes[n], i, boxOf(nodes[child]), child);
    }
  }
  accel.bounds = boxOf(nodes[0]);
  return costOf(accel) <= kWorstGrowth * accel.builtCost;
}

}  // namespace rc::ddk
