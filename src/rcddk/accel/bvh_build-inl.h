// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_build-inl.h: triangles to a BVH of eight children a node, top down by the binned surface area heuristic.
// Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007; a node's largest child is split until
// it has eight (Wald, Benthin, Boulos: "Getting Rid of Packets", RT 2008). Compiled for each instruction set; no
// operation is fused, so that all of them build the same tree.
#if defined(RAYCORE_BVH_BUILD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_BVH_BUILD_INL
#undef RAYCORE_BVH_BUILD_INL
#else
#define RAYCORE_BVH_BUILD_INL
#endif

#include <hwy/highway.h>

#include "rcddk/accel/bvh_parts.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddk::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D4 = hn::CappedTag<float, 4>;
using D8 = hn::CappedTag<float, 8>;

// A box as eight columns: -lower, 0, upper, 0. So one maximum adds a box to another.
struct alignas(32) Box8 {
  float v[8] = {-kInfinity, -kInfinity, -kInfinity, 0, -kInfinity, -kInfinity, -kInfinity, 0};

  HWY_INLINE void add(const float *other) {
    const D8 d;
    for (size_t i = 0; i < 8; i += hn::Lanes(d)) {
      hn::Store(hn::Max(hn::Load(d, v + i), hn::Load(d, other + i)), d, v + i);
    }
  }

  Bounds bounds() const { return {{-v[0], -v[1], -v[2]}, {v[4], v[5], v[6]}}; }
  float size(size_t axis) const { return v[axis] + v[4 + axis]; }
  float halfArea() const { return size(0) * (size(1) + size(2)) + size(1) * size(2); }
};

// References [begin, end), and what is known of them.
struct Range {
  size_t begin, end;
  Box8 box, centres;  // centres: of doubled ones, lower + upper

  size_t count() const { return end - begin; }
};

constexpr size_t kMostBins = 16;

// lower + upper of one axis.
HWY_INLINE float doubledCentre(const BuildReference &reference, size_t axis) {
  return reference.box[4 + axis] - reference.box[axis];
}

// Maps doubled centres to bins. Few references get few bins: finding the best of many costs more than it saves.
struct Binning {
  size_t count;
  float origin[3], scale[3];

  explicit Binning(const Range &range) : count(std::min(kMostBins, 4 + range.count() / 16)) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const float size = range.centres.size(axis);
      origin[axis] = -range.centres.v[axis];
      scale[axis] = size > 0 ? static_cast<float>(count) * 0.9999f / size : 0;
    }
  }
  HWY_INLINE size_t binOf(const BuildReference &reference, size_t axis) const {
    const float place = (doubledCentre(reference, axis) - origin[axis]) * scale[axis];
    // Sizes beyond float, or near nothing, make places that are no numbers.
    return static_cast<size_t>(std::min(place > 0 ? place : 0.0f, static_cast<float>(count - 1)));
  }
};

struct Bins {
  Box8 boxes[3][kMostBins];
  uint32_t counts[3][kMostBins] = {};
};

struct Split {
  size_t axis = 3, bin = 0;  // bins below go left; axis 3: none
  float cost = kInfinity;
};

HWY_INLINE void fill(std::span<const BuildReference> references, const Binning &binning, Bins &bins) {
  for (const BuildReference &reference : references) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const size_t bin = binning.binOf(reference, axis);
      bins.boxes[axis][bin].add(reference.box);
      ++bins.counts[axis][bin];
    }
  }
}

// What a range costs beyond its area: the blocks that its triangles fill.
inline float blocksOf(uint32_t count) {
  return static_cast<float>((count + hal::TriangleBlock4::kWidth - 1) / hal::TriangleBlock4::kWidth);
}

HWY_INLINE void evaluate(const Bins &bins, size_t axis, size_t count, Split &best) {
  float rightCost[kMostBins];
  Box8 box;
  uint32_t n = 0;
  for (size_t i = count - 1; i > 0; --i) {
    box.add(bins.boxes[axis][i].v);
    n += bins.counts[axis][i];
    rightCost[i] = n ? box.halfArea() * blocksOf(n) : kInfinity;
  }
  box = {};
  n = 0;
  for (size_t i = 1; i < count; ++i) {
    box.add(bins.boxes[axis][i - 1].v);
    n += bins.counts[axis][i - 1];
    if (n == 0) continue;
    const float cost = box.halfArea() * blocksOf(n) + rightCost[i];
    if (cost < best.cost) best.axis = axis, best.bin = i, best.cost = cost;
  }
}

class Builder {
 public:
  Builder(std::span<BuildReference> references, std::span<const hal::HotTriangle> triangles)
      : mReferences(references), mTriangles(triangles) {}

  void build(const Bounds &all, BvhPieces &out) {
    Range range{0, mReferences.size(), {}, {}};
    for (size_t axis = 0; axis < 3; ++axis) {
      range.box.v[axis] = -all.lower[axis];
      range.box.v[4 + axis] = all.upper[axis];
    }
    range.centres = centresOf(range);
    out.reserve(mReferences.size());
    node(range, 0, out);
  }

 private:
  static constexpr uint32_t kWidth = hal::BvhNode8::kWidth;
  static constexpr int kBalancedDepth = 24;  // from here on halves, so that no path gets too long

  Box8 centresOf(const Range &range) const {
    Box8 centres;
    for (size_t i = range.begin; i < range.end; ++i) addCentre(mReferences[i], centres);
    return centres;
  }

  static HWY_INLINE void addCentre(const BuildReference &reference, Box8 &centres) {
    const D4 d;
    for (size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto lower = hn::Load(d, reference.box + i), upper = hn::Load(d, reference.box + 4 + i);
      hn::Store(hn::Max(hn::Load(d, centres.v + i), hn::Sub(lower, upper)), d, centres.v + i);
      hn::Store(hn::Max(hn::Load(d, centres.v + 4 + i), hn::Sub(upper, lower)), d, centres.v + 4 + i);
    }
  }

  // Appends the subtree of the range and returns its node.
  uint32_t node(const Range &range, int depth, BvhPieces &out) {
    Range children[kWidth];
    const uint32_t count = divide(range, depth, children);
    const auto place = static_cast<uint32_t>(out.nodes.size());
    out.nodes.emplace_back();
    uint32_t names[kWidth] = {};
    if (range.count() >= kParallelReferences) {
      BvhPieces pieces[kWidth];
      parallel(children, pieces, names, 0, count, depth);
      for (uint32_t i = 0; i < count; ++i) names[i] = out.append(pieces[i], names[i]);
    } else {
      for (uint32_t i = 0; i < count; ++i) names[i] = subtree(children[i], depth, out);
    }
    for (uint32_t i = 0; i < kWidth; ++i) {
      setChild(out.nodes[place], i, i < count ? children[i].box.bounds() : Bounds(), names[i]);
    }
    return place;
  }

  uint32_t subtree(const Range &range, int depth, BvhPieces &out) {
    if (range.count() > hal::TriangleBlock4::kWidth) return node(range, depth + 1, out);
    out.blocks.push_back(makeBlock(mReferences.subspan(range.begin, range.count()), mTriangles));
    return static_cast<uint32_t>(out.blocks.size() - 1) | hal::BvhNode8::kLeaf;
  }

  void parallel(const Range *children, BvhPieces *pieces, uint32_t *names, uint32_t first, uint32_t last, int depth) {
    if (last - first == 1) {
      pieces[first].reserve(children[first].count());
      names[first] = subtree(children[first], depth, pieces[first]);
      return;
    }
    const uint32_t middle = (first + last) / 2;
    both([&] { parallel(children, pieces, names, first, middle, depth); },
         [&] { parallel(children, pieces, names, middle, last, depth); });
  }

  // Splits the child with the largest box until there are eight, or none is left to split.
  uint32_t divide(const Range &range, int depth, Range *children) {
    children[0] = range;
    uint32_t count = 1;
    while (count < kWidth) {
      Range *widest = nullptr;
      float area = -1;
      for (Range &child : std::span(children, count)) {
        if (child.count() <= hal::TriangleBlock4::kWidth || child.box.halfArea() <= area) continue;
        widest = &child;
        area = child.box.halfArea();
      }
      if (!widest) break;
      split(*widest, depth, *widest, children[count++]);
    }
    return count;
  }

  // `left` may be the range itself.
  void split(const Range &whole, int depth, Range &left, Range &right) {
    const Range range = whole;
    const Binning binning(range);
    Bins bins;
    Split best;
    if (depth < kBalancedDepth) {
      fill(mReferences.subspan(range.begin, range.count()), binning, bins);
      for (size_t axis = 0; axis < 3; ++axis) {
        if (binning.scale[axis] > 0) evaluate(bins, axis, binning.count, best);
      }
    }
    if (best.axis == 3) return halve(range, left, right);
    left = right = Range{range.begin, range.end, {}, {}};
    for (size_t i = 0; i < binning.count; ++i) (i < best.bin ? left : right).box.add(bins.boxes[best.axis][i].v);
    left.end = right.begin = partition(range, binning, best, left.centres, right.centres);
  }

  // Sorts the references into halves and collects their centres. There is no branch on the side: it cannot be foretold.
  size_t partition(const Range &range, const Binning &binning, const Split &best, Box8 &left, Box8 &right) {
    Box8 *sides[2] = {&right, &left};
    size_t middle = range.begin;
    for (size_t i = range.begin; i < range.end; ++i) {
      const BuildReference reference = mReferences[i];
      const bool isLeft = binning.binOf(reference, best.axis) < best.bin;
      addCentre(reference, *sides[isLeft]);
      mReferences[i] = mReferences[middle];
      mReferences[middle] = reference;
      middle += isLeft;
    }
    return middle;
  }

  // All centres in one place, too deep, or too far away for areas.
  void halve(const Range &range, Range &left, Range &right) const {
    const size_t middle = range.begin + range.count() / 2;
    left = Range{range.begin, middle, {}, {}};
    right = Range{middle, range.end, {}, {}};
    for (Range *side : {&left, &right}) {
      for (size_t i = side->begin; i < side->end; ++i) side->box.add(mReferences[i].box);
      side->centres = centresOf(*side);
    }
  }

  std::span<BuildReference> mReferences;
  std::span<const hal::HotTriangle> mTriangles;
};

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
