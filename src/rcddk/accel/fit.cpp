// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// fit.cpp: boxes and vertices for a BVH whose nodes and blocks say what belongs together: what a refit does, and the
// last step of a quick build.
#include <array>

#include "rcddk/accel/bvh_parts.h"
#include "rcddk/accel/float4.h"

namespace rc::ddk {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

namespace {

constexpr size_t kNodesATask = 512;

Bounds boxOf(const BvhNode8 &node) {
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    const float *lower = node.planes[axis][0], *upper = node.planes[axis][1];
    box.lower[axis] = least(min(load4(lower), load4(lower + 4)));
    box.upper[axis] = most(max(load4(upper), load4(upper + 4)));
  }
  return box;
}

// Copies the triangles that a block names into it. Returns their box, widened by boxMargin().
Bounds fillBlock(std::span<const HotTriangle> triangles, TriangleBlock4 &block) {
  const HotTriangle *lanes[TriangleBlock4::kWidth];
  for (uint32_t i = 0; i < TriangleBlock4::kWidth; ++i) {
    lanes[i] = &triangles[block.primitive[block.primitive[i] == TriangleBlock4::kNone ? 0 : i]];
  }
  Float4 lower[3], upper[3], largest = all(0);
  for (size_t v = 0; v < 3; ++v) {
    const auto row = [&](int lane) { return load4(reinterpret_cast<const char *>(lanes[lane]) + v * sizeof(Vec3)); };
    const Columns3 columns = transpose(row(0), row(1), row(2), row(3));
    const Float4 axes[] = {columns.x, columns.y, columns.z};
    for (int axis = 0; axis < 3; ++axis) {
      std::memcpy(block.vertices[v][axis], &axes[axis], sizeof(Float4));
      lower[axis] = v == 0 ? axes[axis] : min(lower[axis], axes[axis]);
      upper[axis] = v == 0 ? axes[axis] : max(upper[axis], axes[axis]);
      largest = max(largest, abs(axes[axis]));
    }
  }
  const Float4 margin = max(largest * all(kMarginShare), all(kLeastMargin));
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = least(lower[axis] - margin);
    box.upper[axis] = most(upper[axis] + margin);
  }
  return box;
}

}  // namespace

// From the leaves up, in tasks of nodes that lie beside each other; most of their children do too. What has a child
// in another task comes last.
void fit(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  LargeVector<BvhNode8> &nodes = accel.bvhNodes;
  std::vector<Array<uint32_t>> left((nodes.size() + kNodesATask - 1) / kNodesATask);
  forEachShare(workers, nodes.size(), kNodesATask, [&](size_t task, size_t first, size_t end) {
    std::array<bool, kNodesATask> done{};
    for (size_t n = end; n-- > first;) {
      done[n - first] = true;
      for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
        const uint32_t child = nodes[n].child[i];
        if (child & BvhNode8::kLeaf) {
          setChild(nodes[n], i, fillBlock(triangles, accel.blocks[child & ~BvhNode8::kLeaf]), child);
        } else if (child != 0 && child < end && done[child - first]) {
          setChild(nodes[n], i, boxOf(nodes[child]), child);
        } else if (child != 0) {
          done[n - first] = false;
        }
      }
      if (!done[n - first]) left[task].push_back(static_cast<uint32_t>(n));
    }
  });
  for (size_t task = left.size(); task-- > 0;) {
    for (const uint32_t n : left[task]) {
      for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
        const uint32_t child = nodes[n].child[i];
        if (child != 0 && !(child & BvhNode8::kLeaf)) setChild(nodes[n], i, boxOf(nodes[child]), child);
      }
    }
  }
  accel.bounds = boxOf(nodes[0]);
}

}  // namespace rc::ddk
