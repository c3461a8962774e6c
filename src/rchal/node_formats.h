// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// node_formats.h: what an acceleration structure looks like in memory, named by layout. [G 1.2a]
// The builders in rcddk/accel write it, the traversal unit reads it. Sizes are asserted.
#pragma once

#include <cstdint>
#include <span>

#include "base/bounds.h"
#include "base/settings.h"

namespace rc::hal {

// KD-tree node, 8 bytes. The left child follows its parent; the right one is named by index.
struct KdNode8 {
  static constexpr uint32_t kLeaf = 3;

  union {
    float split;      // inner: position of the plane on `axis`
    uint32_t offset;  // leaf: first entry in AccelView::primitives
  };
  uint32_t word;  // bits 0-1: axis 0-2, or kLeaf; bits 2-31: right child (inner), number of entries (leaf)

  static KdNode8 inner(uint32_t axis, float split, uint32_t right) { return {{.split = split}, axis | right << 2}; }
  static KdNode8 leaf(uint32_t offset, uint32_t count) { return {{.offset = offset}, kLeaf | count << 2}; }

  bool isLeaf() const { return (word & 3) == kLeaf; }
  uint32_t axis() const { return word & 3; }
  uint32_t right() const { return word >> 2; }
  uint32_t count() const { return word >> 2; }
};
static_assert(sizeof(KdNode8) == 8);

// BVH node of up to eight children, 224 bytes: their boxes by plane, so that one load gives a plane of all.
struct alignas(32) BvhNode8 {
  static constexpr uint32_t kWidth = 8;
  static constexpr uint32_t kLeaf = 0x80000000;  // set in `child`: the rest is an index of AccelView::blocks

  float planes[3][2][kWidth];  // 192  by axis; lower, upper; a place without a child has an inverted infinite box
  uint32_t child[kWidth];      //  32  inner: an index of AccelView::bvhNodes; none: 0, the root, nobody's child

  Bounds box(uint32_t i) const {
    return {{planes[0][0][i], planes[1][0][i], planes[2][0][i]}, {planes[0][1][i], planes[1][1][i], planes[2][1][i]}};
  }
};
static_assert(sizeof(BvhNode8) == 224);

// What a BVH leaf is: up to four triangles, their vertices by coordinate. 160 bytes.
// Places that are left repeat the first triangle under the number kNone: whatever they hit, it hit first.
struct alignas(16) TriangleBlock4 {
  static constexpr uint32_t kWidth = 4;
  static constexpr uint32_t kNone = 0xffffffff;

  float vertices[3][3][kWidth];  // 144  by vertex, by axis
  uint32_t primitive[kWidth];    //  16

  uint32_t count() const {
    uint32_t n = 1;
    while (n < kWidth && primitive[n] != kNone) ++n;
    return n;
  }
};
static_assert(sizeof(TriangleBlock4) == 160);

// Neither kind is ever deeper, so a fixed stack suffices.
inline constexpr int kMaxTreeDepth = 64;
inline constexpr int kMaxBvhStack = kMaxTreeDepth * (BvhNode8::kWidth - 1) + 1;

struct AccelView {
  AccelKind kind = AccelKind::Exhaustive;
  Bounds bounds;                           // of all triangles
  Bounds core;                             // of most triangles, without the few that lie or reach far out
  float grain = 0;                         // how long most triangles are, about
  std::span<const KdNode8> kdNodes;        // root first; empty where there is nothing
  std::span<const uint32_t> primitives;    // what the leaves of the KD-tree list: indices of triangles
  std::span<const BvhNode8> bvhNodes;      // root first; empty where there is nothing
  std::span<const TriangleBlock4> blocks;  // the leaves of the BVH
};

}  // namespace rc::hal
