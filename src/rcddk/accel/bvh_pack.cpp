// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/bvh_pack.h"

#include "base/vec.h"

namespace rc::ddk {

uint32_t BinaryTree::add(float area, int depth) {
  Node &node = mNodes.emplace_back();
  node.area = area;
  node.depth = depth;
  return static_cast<uint32_t>(mNodes.size() - 1);
}

uint32_t BinaryTree::divide(uint32_t node, float leftArea, float rightArea) {
  const int depth = mNodes[node].depth + 1;
  const uint32_t left = add(leftArea, depth);
  add(rightArea, depth);
  return mNodes[node].left = left;
}

// cost[i] of what two or more children of another replace.
void BinaryTree::bestShares(Node &node) const {
  const Node &left = mNodes[node.left], &right = mNodes[node.left + 1];
  for (uint32_t i = 2; i <= kWidth; ++i) {
    node.cost[i] = kInfinity;
    node.share[i] = 1;  // also where areas are beyond float
    for (uint32_t k = 1; k < i; ++k) {
      const float cost = left.cost[k] + right.cost[i - k];
      if (!(cost < node.cost[i])) continue;
      node.cost[i] = cost;
      node.share[i] = static_cast<uint8_t>(k);
    }
  }
}

void BinaryTree::pack(float nodeCost) {
  for (size_t n = mNodes.size(); n-- > 0;) {
    Node &node = mNodes[n];
    if (node.left == 0) continue;
    bestShares(node);
    node.cost[1] = node.area + nodeCost + node.cost[kWidth];
    for (uint32_t i = 2; i < kWidth; ++i) {
      if (node.cost[i] <= node.cost[i - 1]) continue;
      node.cost[i] = node.cost[i - 1];
      node.share[i] = node.share[i - 1];
    }
  }
}

uint32_t BinaryTree::expand(uint32_t node, uint32_t places, uint32_t *out, uint32_t count) const {
  const Node &at = mNodes[node];
  const uint32_t left = at.share[places];
  if (at.left == 0 || left == 0) {
    out[count] = node;
    return count + 1;
  }
  return expand(at.left + 1, places - left, out, expand(at.left, left, out, count));
}

uint32_t BinaryTree::childrenOf(uint32_t node, uint32_t (&out)[kWidth]) const { return expand(node, kWidth, out, 0); }

}  // namespace rc::ddk
