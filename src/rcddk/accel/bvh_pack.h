// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_pack.h: which nodes of a binary tree become nodes of eight children, so that rays meet the fewest.
// Ylitie, Karras, Laine: "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, 3.1.
#pragma once

#include "base/memory.h"
#include "rchal/node_formats.h"

namespace rc::ddk {

class BinaryTree {
 public:
  static constexpr uint32_t kWidth = hal::BvhNode8::kWidth;

  // Appends a leaf and returns its number. area: of its box.
  uint32_t add(float area, int depth);
  // Appends two children of a leaf, which no longer is one. Returns the first one's number; the other follows.
  uint32_t divide(uint32_t node, float leftArea, float rightArea);

  bool isLeaf(uint32_t node) const { return mNodes[node].left == 0; }
  int depthOf(uint32_t node) const { return mNodes[node].depth; }

  // Decides. nodeCost: what a node costs besides the rays that meet it, in units of area.
  void pack(float nodeCost);
  // The nodes below an inner one that become its children. Returns how many.
  uint32_t childrenOf(uint32_t node, uint32_t (&out)[kWidth]) const;

 private:
  struct Node {
    float area;
    uint32_t left = 0;  // 0: a leaf; the right one follows
    int depth;
    // If i children of another replace this node and those below, at most: what the nodes among them cost, and how many
    // of the i replace the left child; 0: this node is the only one.
    float cost[kWidth + 1] = {};
    uint8_t share[kWidth + 1] = {};
  };

  void bestShares(Node &node) const;
  uint32_t expand(uint32_t node, uint32_t places, uint32_t *out, uint32_t count) const;

  Array<Node> mNodes;
};

}  // namespace rc::ddk
