// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh.cpp: a bounding volume hierarchy by the binned surface area heuristic.
// Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007.
#include <array>

#include "rcddk/accel/builder.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

// Node of the binary tree that is built first. The left child follows its parent.
struct BinaryNode {
  Bounds box;
  uint32_t index;  // inner: right child; leaf: first reference
  uint32_t count;  // inner: 0; leaf: number of references

  bool isLeaf() const { return count > 0; }
};

constexpr int kBins = 16;
constexpr size_t kLeafSize = TriangleBlock4::kWidth;
constexpr float kNodeCost = 1.2f;   // of a step through an inner node, in triangle tests
constexpr int kBalancedDepth = 30;  // from here on halves, so that the depth stays below kMaxTreeDepth

struct Bin {
  Bounds box;
  size_t count = 0;
};

struct Split {
  int axis = -1;
  int bin = 0;  // bins below go left
  float cost = kInfinity;
};

// Maps the centre of a reference to its bin.
struct Binning {
  Vec3 origin, scale;

  explicit Binning(const Bounds &centres) : origin(centres.lower) {
    const Vec3 size = centres.size();
    for (int axis = 0; axis < 3; ++axis) scale[axis] = size[axis] > 0 ? kBins * 0.9999f / size[axis] : 0;
  }
  int operator()(const Reference &reference, int axis) const {
    const float bin = (reference.box.centre()[axis] - origin[axis]) * scale[axis];
    return std::clamp(static_cast<int>(std::min(bin, float(kBins))), 0, kBins - 1);
  }
};

class BvhBuilder {
 public:
  BvhBuilder(std::span<Reference> references, std::span<BinaryNode> slots) : mReferences(references), mSlots(slots) {}

  // Builds the subtree of references [begin, end) into the slots from `slot` on; it needs at most
  // 2 (end - begin) - 1 of them. So siblings know their places without asking each other.
  void build(size_t begin, size_t end, size_t slot, int depth) {
    Bounds box, centres;
    for (const Reference &reference : mReferences.subspan(begin, end - begin)) {
      box.add(reference.box);
      centres.add(reference.box.centre());
    }
    const size_t middle = partition(begin, end, box, centres, depth);
    if (middle == begin) {
      mSlots[slot] = {box, static_cast<uint32_t>(begin), static_cast<uint32_t>(end - begin)};
      return;
    }
    const size_t right = slot + 2 * (middle - begin);
    mSlots[slot] = {box, static_cast<uint32_t>(right), 0};
    const auto buildLeft = [&] { build(begin, middle, slot + 1, depth + 1); };
    const auto buildRight = [&] { build(middle, end, right, depth + 1); };
    if (end - begin >= kParallelReferences) {
      both(buildLeft, buildRight);
    } else {
      buildLeft();
      buildRight();
    }
  }

 private:
  // Where the right half begins, after sorting the references into halves; `begin` for a leaf.
  size_t partition(size_t begin, size_t end, const Bounds &box, const Bounds &centres, int depth) {
    const size_t count = end - begin;
    if (count <= kLeafSize) return begin;
    const Binning binning(centres);
    const Split split = depth < kBalancedDepth ? bestSplit(begin, end, box, binning) : Split{};
    if (split.axis < 0) return begin + count / 2;  // all centres in one place, or too deep
    const auto first = mReferences.begin();
    const auto middle = std::partition(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end),
                                       [&](const Reference &r) { return binning(r, split.axis) < split.bin; });
    return static_cast<size_t>(middle - first);
  }

  Split bestSplit(size_t begin, size_t end, const Bounds &box, const Binning &binning) const {
    std::array<std::array<Bin, kBins>, 3> bins{};
    for (const Reference &reference : mReferences.subspan(begin, end - begin)) {
      for (int axis = 0; axis < 3; ++axis) {
        Bin &bin = bins[size_t(axis)][size_t(binning(reference, axis))];
        bin.box.add(reference.box);
        ++bin.count;
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) evaluate(bins[size_t(axis)], axis, box.halfArea(), best);
    return best;
  }

  static void evaluate(const std::array<Bin, kBins> &bins, int axis, double area, Split &best) {
    std::array<double, kBins> rightCost{};
    Bin right;
    for (size_t i = kBins - 1; i > 0; --i) {
      right.box.add(bins[i].box);
      right.count += bins[i].count;
      rightCost[i] = right.count ? right.box.halfArea() * static_cast<double>(right.count) : -1;
    }
    Bin left;
    for (size_t i = 1; i < kBins; ++i) {
      left.box.add(bins[i - 1].box);
      left.count += bins[i - 1].count;
      if (left.count == 0 || rightCost[i] < 0) continue;
      const double tests = left.box.halfArea() * static_cast<double>(left.count) + rightCost[i];
      const auto cost = static_cast<float>(kNodeCost + tests / std::max(area, 1e-300));
      if (cost < best.cost) best = {axis, static_cast<int>(i), cost};
    }
  }

  std::span<Reference> mReferences;
  std::span<BinaryNode> mSlots;
};

// Gathers the binary tree into nodes of eight: the inner child with the largest box is replaced by its own
// children until the node is full (Wald, Benthin, Boulos: "Getting Rid of Packets", RT 2008).
class Collapser {
 public:
  Collapser(std::span<const BinaryNode> slots, std::span<const Reference> references,
            std::span<const HotTriangle> triangles, Accel &accel)
      : mSlots(slots), mReferences(references), mTriangles(triangles), mAccel(accel) {}

  // The root is a node, even if all it has is a leaf.
  void collapseRoot() { collapseInner(0); }

 private:
  // Returns what a parent names the node by, as in BvhNode8::child.
  uint32_t collapse(uint32_t slot) { return mSlots[slot].isLeaf() ? addBlock(mSlots[slot]) : collapseInner(slot); }

  uint32_t collapseInner(uint32_t slot) {
    uint32_t children[BvhNode8::kWidth] = {slot};
    uint32_t count = 1;
    while (count < BvhNode8::kWidth) {
      uint32_t *widest = nullptr;
      for (uint32_t &child : std::span(children, count)) {
        if (mSlots[child].isLeaf()) continue;
        if (!widest || mSlots[child].box.halfArea() > mSlots[*widest].box.halfArea()) widest = &child;
      }
      if (!widest) break;
      children[count++] = mSlots[*widest].index;
      *widest = *widest + 1;
    }
    const auto place = static_cast<uint32_t>(mAccel.bvhNodes.size());
    mAccel.bvhNodes.emplace_back();
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const uint32_t child = i < count ? collapse(children[i]) : 0;
      setChild(mAccel.bvhNodes[place], i, i < count ? mSlots[children[i]].box : Bounds(), child);
    }
    return place;
  }

  static void setChild(BvhNode8 &node, uint32_t i, const Bounds &box, uint32_t child) {
    for (int axis = 0; axis < 3; ++axis) {
      node.planes[axis][0][i] = box.lower[axis];
      node.planes[axis][1][i] = box.upper[axis];
    }
    node.child[i] = child;
  }

  uint32_t addBlock(const BinaryNode &leaf) {
    const auto place = static_cast<uint32_t>(mAccel.blocks.size());
    TriangleBlock4 &block = mAccel.blocks.emplace_back();
    for (uint32_t lane = 0; lane < TriangleBlock4::kWidth; ++lane) {
      const uint32_t primitive = mReferences[leaf.index + (lane < leaf.count ? lane : 0)].primitive;
      const HotTriangle &triangle = mTriangles[primitive];
      const Vec3 *vertices[] = {&triangle.v0, &triangle.v1, &triangle.v2};
      for (int v = 0; v < 3; ++v) {
        for (int axis = 0; axis < 3; ++axis) block.vertices[v][axis][lane] = (*vertices[v])[axis];
      }
      block.primitive[lane] = lane < leaf.count ? primitive : TriangleBlock4::kNone;
    }
    return place | BvhNode8::kLeaf;
  }

  std::span<const BinaryNode> mSlots;
  std::span<const Reference> mReferences;
  std::span<const HotTriangle> mTriangles;
  Accel &mAccel;
};

}  // namespace

void buildBvh(std::span<const HotTriangle> triangles, Accel &accel) {
  std::vector<Reference> references = makeReferences(triangles, accel.bounds);
  std::vector<BinaryNode> slots(2 * references.size());
  BvhBuilder(references, slots).build(0, references.size(), 0, 0);
  Collapser(slots, references, triangles, accel).collapseRoot();
  accel.bvhNodes.shrink_to_fit();
  accel.blocks.shrink_to_fit();
}

}  // namespace rc::ddk
