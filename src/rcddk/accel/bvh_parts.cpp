// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/bvh_parts.h"

namespace rc::ddk {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

Array<BuildReference> makeBuildReferences(std::span<const HotTriangle> triangles, Bounds &all) {
  Array<BuildReference> references(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    const HotTriangle &t = triangles[i];
    const float margin = boxMargin(t);
    const Bounds box{glm::min(t.v0, glm::min(t.v1, t.v2)) - margin, glm::max(t.v0, glm::max(t.v1, t.v2)) + margin};
    references[i] = {box, static_cast<uint32_t>(i)};
    all.add(box);
  }
  return references;
}

void BvhPieces::reserve(size_t triangles) {
  nodes.reserve(triangles / 16 + 8);
  blocks.reserve(triangles / 3 + 8);
}

uint32_t BvhPieces::append(const BvhPieces &other, uint32_t name) {
  const auto nodeBase = static_cast<uint32_t>(nodes.size()), blockBase = static_cast<uint32_t>(blocks.size());
  const auto rename = [&](uint32_t child) { return child + (child & BvhNode8::kLeaf ? blockBase : nodeBase); };
  for (const BvhNode8 &node : other.nodes) {
    BvhNode8 &copy = nodes.emplace_back(node);
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const bool none = copy.planes[0][0][i] > copy.planes[0][1][i];
      if (!none) copy.child[i] = rename(copy.child[i]);
    }
  }
  blocks.insert(blocks.end(), other.blocks.begin(), other.blocks.end());
  return rename(name);
}

void setChild(BvhNode8 &node, uint32_t i, const Bounds &box, uint32_t child) {
  for (int axis = 0; axis < 3; ++axis) {
    node.planes[axis][0][i] = box.lower[axis];
    node.planes[axis][1][i] = box.upper[axis];
  }
  node.child[i] = child;
}

TriangleBlock4 makeBlock(std::span<const BuildReference> references, std::span<const HotTriangle> triangles) {
  TriangleBlock4 block;
  for (uint32_t lane = 0; lane < TriangleBlock4::kWidth; ++lane) {
    const bool used = lane < references.size();
    const HotTriangle &triangle = triangles[references[used ? lane : 0].primitive()];
    block.primitive[lane] = used ? references[lane].primitive() : TriangleBlock4::kNone;
    const Vec3 *vertices[] = {&triangle.v0, &triangle.v1, &triangle.v2};
    for (int v = 0; v < 3; ++v) {
      for (int axis = 0; axis < 3; ++axis) block.vertices[v][axis][lane] = (*vertices[v])[axis];
    }
  }
  return block;
}

}  // namespace rc::ddk
