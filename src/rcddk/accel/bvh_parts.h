// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_parts.h: what builders of BVHs share: references, subtrees that grow apart, nodes and blocks.
#pragma once

#include <bit>

#include "rcddk/accel/builder.h"

namespace rc::ddk {

// A triangle on its way through a builder; 32 bytes, its box in one load.
struct alignas(32) BuildReference {
  float box[8];  // -lower, 0, upper, name

  BuildReference() = default;
  BuildReference(const Bounds &bounds, uint32_t primitive)
      : box{-bounds.lower.x, -bounds.lower.y, -bounds.lower.z, 0,
            bounds.upper.x,  bounds.upper.y,  bounds.upper.z,  nameOf(primitive)} {}

  // The eighth column takes part in arithmetic: the number lies in it as the bits of a float from 2 upwards.
  static float nameOf(uint32_t primitive) { return std::bit_cast<float>(primitive | 0x40000000u); }
  Bounds bounds() const { return {{-box[0], -box[1], -box[2]}, {box[4], box[5], box[6]}}; }
  uint32_t primitive() const { return std::bit_cast<uint32_t>(box[7]) & 0x3fffffffu; }
};
static_assert(sizeof(BuildReference) == 32);

// One for each triangle, widened by boxMargin(). `all` becomes their union.
Array<BuildReference> makeBuildReferences(std::span<const hal::HotTriangle> triangles, Bounds &all);

// A subtree with numbers of its own.
struct BvhPieces {
  LargeVector<hal::BvhNode8> nodes;
  LargeVector<hal::TriangleBlock4> blocks;

  void reserve(size_t triangles);
  // Puts another subtree behind this one. Returns what `name` of it, as in BvhNode8::child, is called here.
  uint32_t append(const BvhPieces &other, uint32_t name);
};

void setChild(hal::BvhNode8 &node, uint32_t i, const Bounds &box, uint32_t child);

// Gives a tree, whose nodes and blocks say what belongs together, the boxes and vertices of its triangles.
// Children lie behind their parents.
void fit(std::span<const hal::HotTriangle> triangles, const Workers &workers, Accel &accel);

// At most four references.
hal::TriangleBlock4 makeBlock(std::span<const BuildReference> references, std::span<const hal::HotTriangle> triangles);

}  // namespace rc::ddk
