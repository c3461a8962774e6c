// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/shape.h"

namespace rc::ddk {
namespace {

AccelShape shapeOfBvh(const Accel &accel) {
  AccelShape shape{accel.bvhNodes.size(), accel.blocks.size(), 0, costOf(accel)};
  std::vector<int> depths(accel.bvhNodes.size(), 1);
  for (size_t n = 0; n < accel.bvhNodes.size(); ++n) {  // children lie behind their parents
    for (const uint32_t child : accel.bvhNodes[n].child) {
      if (child == 0) continue;
      shape.depth = std::max(shape.depth, depths[n] + 1);
      if (!(child & hal::BvhNode8::kLeaf)) depths[child] = depths[n] + 1;
    }
  }
  return shape;
}

AccelShape shapeOfKdTree(const Accel &accel) {
  struct Entry {
    uint32_t node;
    int depth;
    Bounds cell;
  };
  AccelShape shape;
  const double whole = std::max<double>(accel.bounds.halfArea(), 1e-300);
  std::vector<Entry> waiting{{0, 1, accel.bounds}};
  while (!waiting.empty()) {
    const Entry at = waiting.back();
    waiting.pop_back();
    const hal::KdNode8 &node = accel.kdNodes[at.node];
    shape.depth = std::max(shape.depth, at.depth);
    shape.cost += at.cell.halfArea() / whole;
    ++(node.isLeaf() ? shape.leaves : shape.nodes);
    if (node.isLeaf()) continue;
    Entry left{at.node + 1, at.depth + 1, at.cell}, right{node.right(), at.depth + 1, at.cell};
    left.cell.upper[node.axis()] = right.cell.lower[node.axis()] = node.split;
    waiting.push_back(left);
    waiting.push_back(right);
  }
  return shape;
}

}  // namespace

AccelShape shapeOf(const Accel &accel) {
  if (!accel.bvhNodes.empty()) return shapeOfBvh(accel);
  return accel.kdNodes.empty() ? AccelShape{} : shapeOfKdTree(accel);
}

}  // namespace rc::ddk
