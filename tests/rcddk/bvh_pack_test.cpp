// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Nodes of eight children from a binary tree, against every way to choose them.
#include "rcddk/accel/bvh_pack.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

namespace rc::ddk {
namespace {

struct Made {
  BinaryTree tree;
  std::vector<uint32_t> left;  // of each node; 0: a leaf
  std::vector<float> area;

  void divide(uint32_t node, float share) {
    left[node] = tree.divide(node, area[node] * share, area[node] * (1.3f - share));
    for (const float part : {share, 1.3f - share}) {
      left.push_back(0);
      area.push_back(area[node] * part);
    }
  }
};

// Leaves are divided at random until there are so many.
Made makeTree(uint32_t leaves, std::mt19937 &random) {
  Made made;
  made.tree.add(1, 0);
  made.left = {0};
  made.area = {1};
  std::uniform_real_distribution<float> share(0.2f, 0.9f);
  while (made.left.size() < 2 * leaves - 1) {
    const auto node = static_cast<uint32_t>(random() % made.left.size());
    if (made.left[node] == 0) made.divide(node, share(random));
  }
  return made;
}

// The cost of what pack() chose. Counts the leaves it reaches.
double costOf(const Made &made, float nodeCost, uint32_t node, uint32_t &leaves) {
  if (made.tree.isLeaf(node)) {
    ++leaves;
    return 0;
  }
  uint32_t children[BinaryTree::kWidth];
  const uint32_t count = made.tree.childrenOf(node, children);
  EXPECT_GE(count, 2u);
  EXPECT_LE(count, BinaryTree::kWidth);
  double cost = made.area[node] + nodeCost;
  for (uint32_t i = 0; i < count; ++i) cost += costOf(made, nodeCost, children[i], leaves);
  return cost;
}

// Children of a node if those whose bits are set are nodes of their own.
uint32_t childrenOf(const Made &made, uint32_t chosen, uint32_t node) {
  uint32_t count = 0;
  for (const uint32_t child : {made.left[node], made.left[node] + 1}) {
    const bool own = made.left[child] == 0 || (chosen >> child & 1);
    count += own ? 1 : childrenOf(made, chosen, child);
  }
  return count;
}

double leastCost(const Made &made, float nodeCost) {
  double least = std::numeric_limits<double>::infinity();
  for (uint32_t chosen = 1; chosen < 1u << made.left.size(); chosen += 2) {
    double cost = 0;
    bool possible = true;
    for (uint32_t n = 0; n < made.left.size() && possible; ++n) {
      if (!(chosen >> n & 1)) continue;
      possible = made.left[n] != 0 && childrenOf(made, chosen, n) <= BinaryTree::kWidth;
      cost += made.area[n] + nodeCost;
    }
    if (possible) least = std::min(least, cost);
  }
  return least;
}

TEST(BvhPack, ChoosesTheCheapestNodes) {
  std::mt19937 random(7);
  for (const uint32_t leaves : {2u, 8u, 9u, 10u}) {
    for (const float nodeCost : {0.0f, 0.03f, 2.0f}) {
      for (int i = 0; i < 5; ++i) {
        Made made = makeTree(leaves, random);
        made.tree.pack(nodeCost);
        uint32_t reached = 0;
        EXPECT_NEAR(costOf(made, nodeCost, 0, reached), leastCost(made, nodeCost), 1e-5);
        EXPECT_EQ(reached, leaves);
      }
    }
  }
}

TEST(BvhPack, FewestNodesWhereNodesAreDear) {
  std::mt19937 random(3);
  for (const uint32_t leaves : {15u, 16u, 100u}) {
    Made made = makeTree(leaves, random);
    made.tree.pack(1000);
    uint32_t reached = 0;
    const double nodes = costOf(made, 1000, 0, reached) / 1000;
    EXPECT_EQ(reached, leaves);
    EXPECT_LE(nodes, 1.5 * (leaves - 1) / (BinaryTree::kWidth - 1) + 1);
  }
}

// Areas that are no numbers, or beyond float, still give a tree.
TEST(BvhPack, AreasBeyondFloat) {
  for (const float area : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    Made made;
    made.tree.add(area, 0);
    made.left = {0};
    made.area = {area};
    for (uint32_t n = 0; n < 40; ++n) made.divide(n, 0.5f);
    made.tree.pack(area);
    uint32_t reached = 0;
    costOf(made, 0, 0, reached);
    EXPECT_EQ(reached, 41u);
  }
}

}  // namespace
}  // namespace rc::ddk
