// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh.cpp: a bounding volume hierarchy by the binned surface area heuristic.
// Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007.
#include <array>

#include "rcddk/accel/builder.h"

namespace rc::ddk {
namespace {

using hal::BvhNode32;
using hal::HotTriangle;

constexpr int kBins = 16;
constexpr size_t kLeafSize = 4;     // at most, where the heuristic has a choice
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
  BvhBuilder(std::span<Reference> references, std::span<BvhNode32> slots) : mReferences(references), mSlots(slots) {}

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
      mSlots[slot] = {box.lower, static_cast<uint32_t>(begin), box.upper, static_cast<uint32_t>(end - begin)};
      return;
    }
    const size_t right = slot + 2 * (middle - begin);
    mSlots[slot] = {box.lower, static_cast<uint32_t>(right), box.upper, 0};
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
    if (count == 1) return begin;
    const Binning binning(centres);
    const Split split = depth < kBalancedDepth ? bestSplit(begin, end, box, binning) : Split{};
    const auto leafCost = static_cast<float>(count);
    if (count <= kLeafSize && !(split.cost < leafCost)) return begin;
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
  std::span<BvhNode32> mSlots;
};

// Copies the used slots into depth-first order without gaps.
uint32_t compact(std::span<const BvhNode32> slots, size_t slot, std::vector<BvhNode32> &nodes) {
  const auto place = static_cast<uint32_t>(nodes.size());
  nodes.push_back(slots[slot]);
  if (!slots[slot].isLeaf()) {
    compact(slots, slot + 1, nodes);
    nodes[place].index = compact(slots, slots[slot].index, nodes);
  }
  return place;
}

}  // namespace

void buildBvh(std::span<const HotTriangle> triangles, Accel &accel) {
  std::vector<Reference> references = makeReferences(triangles, accel.bounds);
  std::vector<BvhNode32> slots(2 * references.size() - 1);
  BvhBuilder(references, slots).build(0, references.size(), 0, 0);
  accel.bvhNodes.reserve(slots.size());
  compact(slots, 0, accel.bvhNodes);
  accel.bvhNodes.shrink_to_fit();
  accel.primitives.reserve(references.size());
  for (const Reference &reference : references) accel.primitives.push_back(reference.primitive);
}

}  // namespace rc::ddk
