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

// BVH node, 32 bytes. The left child follows its parent; the right one is named by index.
struct BvhNode32 {
  Vec3 lower;      // 12
  uint32_t index;  //  4  inner: right child; leaf: first entry in AccelView::primitives
  Vec3 upper;      // 12
  uint32_t count;  //  4  inner: 0; leaf: number of entries

  bool isLeaf() const { return count > 0; }
};
static_assert(sizeof(BvhNode32) == 32);

// Neither kind is ever deeper, so a fixed stack suffices.
inline constexpr int kMaxTreeDepth = 64;

struct AccelView {
  AccelKind kind = AccelKind::Exhaustive;
  Bounds bounds;                         // of all triangles
  std::span<const KdNode8> kdNodes;      // root first; empty where there is nothing
  std::span<const BvhNode32> bvhNodes;   // root first; empty where there is nothing
  std::span<const uint32_t> primitives;  // what the leaves list: indices of triangles
};

}  // namespace rc::hal
