// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_build-inl.h: triangles to a BVH of eight children a node, top down by the binned surface area heuristic.
// Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007; a node's largest child is split until
// it has eight (Wald, Benthin, Boulos: "Getting Rid of Packets", RT 2008); near the leaves the best nodes are chosen.
// Compiled for each instruction set; no operation is fused, so that all of them build the same tree. Trees that live
// long cut triangles where that pays.
#if defined(RAYCORE_BVH_BUILD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_BVH_BUILD_INL
#undef RAYCORE_BVH_BUILD_INL
#else
#define RAYCORE_BVH_BUILD_INL
#endif

#include "rcddk/accel/bvh_pack.h"
#include "rcddk/accel/bvh_spatial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddk::HWY_NAMESPACE {

class Builder {
 public:
  // references: one for each triangle; what room there is behind them is for parts of triangles.
  Builder(std::span<BuildReference> references, std::span<const hal::HotTriangle> triangles)
      : mReferences(references), mTriangles(triangles) {}

  void build(const Bounds &all, BvhPieces &out) {
    Range range{0, mTriangles.size(), mReferences.size(), {}, {}};
    for (size_t axis = 0; axis < 3; ++axis) {
      range.box.v[axis] = -all.lower[axis];
      range.box.v[4 + axis] = all.upper[axis];
    }
    range.centres = centresOf(range);
    mLeastOverlap = range.box.halfArea() * kOverlapOfScene;
    out.reserve(mReferences.size());
    node(range, 0, out);
  }

 private:
  static constexpr uint32_t kWidth = hal::BvhNode8::kWidth;
  // Smaller overlaps of halves cost rays less than looking for planes costs: shares of the surface of the scene, and of
  // the range. Measured with bench/build and bench/trace: meshes, which gain nothing, look for planes at the top alone.
  static constexpr float kOverlapOfScene = 0.01f, kOverlapOfRange = 0.3f;
  // So few references are divided down to their leaves before nodes are made of them. More make hardly a difference.
  static constexpr size_t kPacked = 256;
  static constexpr float kNodeCost = 0.03f;  // of a node besides the rays that meet it, as a share of their box
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
    if (range.count() > hal::TriangleBlock4::kWidth && range.count() <= kPacked) return packed(range, depth, out);
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
    return range.count() > hal::TriangleBlock4::kWidth ? node(range, depth + 1, out) : leaf(range, out);
  }

  // The same for a range so small that it is divided down to its leaves first. Depths count halves from here on.
  uint32_t packed(const Range &range, int depth, BvhPieces &out) {
    Array<Range> ranges{range};
    BinaryTree tree;
    tree.add(range.box.halfArea(), depth);
    for (uint32_t n = 0; n < ranges.size(); ++n) {
      if (ranges[n].count() <= hal::TriangleBlock4::kWidth) continue;
      Range left, right;
      split(ranges[n], tree.depthOf(n), left, right);
      tree.divide(n, left.box.halfArea(), right.box.halfArea());
      ranges.push_back(left);
      ranges.push_back(right);
    }
    tree.pack(kNodeCost * range.box.halfArea());
    return append(tree, ranges, 0, out);
  }

  uint32_t append(const BinaryTree &tree, std::span<const Range> ranges, uint32_t node, BvhPieces &out) {
    if (tree.isLeaf(node)) return leaf(ranges[node], out);
    uint32_t children[kWidth];
    const uint32_t count = tree.childrenOf(node, children);
    const auto place = static_cast<uint32_t>(out.nodes.size());
    out.nodes.emplace_back();
    for (uint32_t i = 0; i < kWidth; ++i) {
      const uint32_t name = i < count ? append(tree, ranges, children[i], out) : 0;
      setChild(out.nodes[place], i, i < count ? ranges[children[i]].box.bounds() : Bounds(), name);
    }
    return place;
  }

  uint32_t leaf(const Range &range, BvhPieces &out) {
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
    left = right = Range{range.begin, range.end, range.limit, {}, {}};
    for (size_t i = 0; i < binning.count; ++i) (i < best.bin ? left : right).box.add(bins.boxes[best.axis][i].v);
    const float least = std::max(mLeastOverlap, range.box.halfArea() * kOverlapOfRange);
    const bool overlap = range.limit > range.end && left.box.overlap(right.box) > least;
    if (overlap && cutApart(range, best.cost, left, right)) return;
    left.end = right.begin = partition(range, binning, best, left.centres, right.centres);
    share(left, right);
  }

  // Shares out the room behind the right half, by their numbers of references.
  void share(Range &left, Range &right) {
    const size_t room = right.limit - right.end, count = left.count() + right.count();
    const size_t shift = room * left.count() / count;
    left.limit = left.end + shift;
    if (shift == 0) return;
    const size_t moved = std::min(shift, right.count());
    std::copy_n(&mReferences[right.begin], moved, &mReferences[right.end + shift - moved]);
    right.begin += shift;
    right.end += shift;
  }

  // Divides the range by a plane if that costs less, and there is room for the triangles that it cuts.
  bool cutApart(const Range &range, float cost, Range &left, Range &right) {
    const auto references = mReferences.subspan(range.begin, range.count());
    const Slabs slabs(range.box);
    const SpatialSplit split = bestPlane(references, mTriangles, slabs);
    if (!(split.cost < cost) || split.left + split.right > range.limit - range.begin) return false;
    const Parts parts = partsOf(references, mTriangles, slabs, split);
    if (parts.left.empty() || parts.right.empty()) return false;
    const size_t middle = range.begin + parts.left.size(), end = middle + parts.right.size();
    std::copy(parts.left.begin(), parts.left.end(), &mReferences[range.begin]);
    std::copy(parts.right.begin(), parts.right.end(), &mReferences[middle]);
    left = {range.begin, middle, middle, {}, {}};
    right = {middle, end, range.limit, {}, {}};
    for (Range *side : {&left, &right}) measure(*side);
    share(left, right);
    return true;
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
    left = Range{range.begin, middle, middle, {}, {}};
    right = Range{middle, range.end, range.limit, {}, {}};
    for (Range *side : {&left, &right}) measure(*side);
  }

  void measure(Range &range) const {
    for (size_t i = range.begin; i < range.end; ++i) range.box.add(mReferences[i].box);
    range.centres = centresOf(range);
  }

  std::span<BuildReference> mReferences;
  std::span<const hal::HotTriangle> mTriangles;
  float mLeastOverlap = 0;  // of halves, for which planes are tried
};

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
