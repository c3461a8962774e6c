// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// kdtree.cpp: a KD-tree by the surface area heuristic, the guide's default structure.
// Planes are chosen by min-max binning (Shevtsov, Soupikov, Kapustin: "Highly Parallel Fast KD-tree
// Construction", 2007); triangles that a plane cuts go to both sides with boxes of their parts.
#include <algorithm>
#include <array>

#include "rcddk/accel/cut.h"

namespace rc::ddk {
namespace {

using hal::HotTriangle;
using hal::KdNode8;

constexpr int kBins = 32;
constexpr float kNodeCost = 1.0f;      // of a step through an inner node, in triangle tests
constexpr float kEmptyFactor = 0.8f;   // what a split costs that cuts empty space off
constexpr size_t kLeafSize = 2;        // not worth splitting
constexpr size_t kMostDuplicates = 8;  // references that cutting may add, for each triangle
constexpr int kMaxBadSplits = 3;       // on a path: splits that do not pay by themselves may pay below

struct Split {
  int axis = -1;
  float position = 0;
  float cost = kInfinity;
};

struct Subtree {
  Array<KdNode8> nodes;
  Array<uint32_t> primitives;

  // Puts another subtree behind this one.
  void append(const Subtree &other) {
    const auto nodeBase = static_cast<uint32_t>(nodes.size()), primitiveBase = static_cast<uint32_t>(primitives.size());
    for (KdNode8 node : other.nodes) {
      nodes.push_back(node.isLeaf() ? KdNode8::leaf(node.offset + primitiveBase, node.count())
                                    : KdNode8::inner(node.axis(), node.split, node.right() + nodeBase));
    }
    primitives.insert(primitives.end(), other.primitives.begin(), other.primitives.end());
  }
};

class KdBuilder {
 public:
  explicit KdBuilder(std::span<const HotTriangle> triangles) : mTriangles(triangles) {}

  // Appends the subtree of the references, which all reach into the cell, to `out`.
  // budget: how many references may be added by cutting triangles.
  void build(Array<Reference> references, const Bounds &cell, int depthLeft, int badSplits, size_t budget,
             Subtree &out) const {
    const Split split = depthLeft > 0 && references.size() > kLeafSize ? bestSplit(references, cell) : Split{};
    const auto leafCost = static_cast<float>(references.size());
    if (split.cost > leafCost) ++badSplits;
    if (split.axis < 0 || badSplits > kMaxBadSplits || (split.cost > 4 * leafCost && references.size() < 16)) {
      makeLeaf(references, out);
      return;
    }
    Array<Reference> left, right;
    distribute(references, split, left, right);
    const size_t total = left.size() + right.size(), added = total - std::min(total, references.size());
    if (added == references.size() || added > budget) {  // the plane separates nothing, or too little for its price
      makeLeaf(references, out);
      return;
    }
    const size_t leftBudget = (budget - added) * left.size() / total, rightBudget = budget - added - leftBudget;
    const bool parallel = references.size() >= kParallelReferences;
    Array<Reference>().swap(references);  // = {} would keep its memory
    Bounds leftCell = cell, rightCell = cell;
    leftCell.upper[split.axis] = rightCell.lower[split.axis] = split.position;

    const size_t node = out.nodes.size();
    out.nodes.push_back({});
    size_t rightIndex = 0;
    if (parallel) {
      Subtree leftTree, rightTree;
      both([&] { build(std::move(left), leftCell, depthLeft - 1, badSplits, leftBudget, leftTree); },
           [&] { build(std::move(right), rightCell, depthLeft - 1, badSplits, rightBudget, rightTree); });
      out.append(leftTree);
      rightIndex = out.nodes.size();
      out.append(rightTree);
    } else {
      build(std::move(left), leftCell, depthLeft - 1, badSplits, leftBudget, out);
      rightIndex = out.nodes.size();
      build(std::move(right), rightCell, depthLeft - 1, badSplits, rightBudget, out);
    }
    out.nodes[node] = KdNode8::inner(uint32_t(split.axis), split.position, static_cast<uint32_t>(rightIndex));
  }

 private:
  static void makeLeaf(const Array<Reference> &references, Subtree &out) {
    out.nodes.push_back(KdNode8::leaf(uint32_t(out.primitives.size()), uint32_t(references.size())));
    for (const Reference &reference : references) out.primitives.push_back(reference.primitive);
  }

  static Split bestSplit(const Array<Reference> &references, const Bounds &cell) {
    Bounds content;  // planes beyond it would only cut more empty space
    for (const Reference &reference : references) content.add(reference.box);
    Split best;
    for (int axis = 0; axis < 3; ++axis) evaluate(references, content, cell, axis, best);
    return best;
  }

  // Counts where boxes begin and end; sums of the counts tell how many lie on each side of a bin's border.
  static void evaluate(const Array<Reference> &references, const Bounds &content, const Bounds &cell, int axis,
                       Split &best) {
    const float lower = content.lower[axis], size = content.size()[axis];
    if (!(size > 0) || !std::isfinite(size)) return;
    const float scale = kBins * 0.9999f / size;
    const auto binOf = [&](float x) {
      const float place = (x - lower) * scale;  // of a size near nothing it may be no number
      return static_cast<size_t>(std::min(place > 0 ? place : 0.0f, kBins - 1.0f));
    };
    std::array<size_t, kBins> begins{}, ends{};
    for (const Reference &reference : references) {
      ++begins[binOf(reference.box.lower[axis])];
      ++ends[binOf(reference.box.upper[axis])];
    }
    size_t left = 0, right = references.size();
    for (int border = 0; border <= kBins; ++border) {
      if (border > 0) {
        left += begins[size_t(border - 1)];
        right -= ends[size_t(border - 1)];
      }
      const float position = border == 0       ? lower
                             : border == kBins ? content.upper[axis]
                                               : lower + size * static_cast<float>(border) / kBins;
      if (position <= cell.lower[axis] || position >= cell.upper[axis]) continue;
      Bounds leftCell = cell, rightCell = cell;
      leftCell.upper[axis] = rightCell.lower[axis] = position;
      const double tests = leftCell.halfArea() * double(left) + rightCell.halfArea() * double(right);
      const double factor = left == 0 || right == 0 ? kEmptyFactor : 1;
      const auto cost = static_cast<float>(kNodeCost + factor * tests / cell.halfArea());
      if (cost < best.cost) best = {axis, position, cost};
    }
  }

  void distribute(const Array<Reference> &references, const Split &split, Array<Reference> &left,
                  Array<Reference> &right) const {
    const auto below = [&](const Reference &r) { return r.box.upper[split.axis] <= split.position; };
    const auto above = [&](const Reference &r) { return !below(r) && r.box.lower[split.axis] >= split.position; };
    const auto leftAlone = static_cast<size_t>(std::ranges::count_if(references, below));
    const auto rightAlone = static_cast<size_t>(std::ranges::count_if(references, above));
    left.reserve(references.size() - rightAlone);
    right.reserve(references.size() - leftAlone);
    for (const Reference &reference : references) {
      if (below(reference)) {
        left.push_back(reference);
      } else if (above(reference)) {
        right.push_back(reference);
      } else {
        cutAndKeep(reference, split, left, right);
      }
    }
  }

  // A part that misses the old box is dropped.
  void cutAndKeep(const Reference &reference, const Split &split, Array<Reference> &left,
                  Array<Reference> &right) const {
    CutBoxes parts = cut(mTriangles[reference.primitive], reference.box, split.axis, split.position);
    parts.below.upper[split.axis] = parts.above.lower[split.axis] = split.position;
    if (!parts.below.empty()) left.push_back({parts.below, reference.primitive});
    if (!parts.above.empty()) right.push_back({parts.above, reference.primitive});
  }

  std::span<const HotTriangle> mTriangles;
};

}  // namespace

void buildKdTree(std::span<const HotTriangle> triangles, Accel &accel) {
  Array<Reference> references = makeReferences(triangles, accel.bounds);
  const int depth =
      std::min(8 + static_cast<int>(1.3f * std::log2(static_cast<float>(references.size()))), hal::kMaxTreeDepth - 2);
  Subtree tree;
  const size_t budget = kMostDuplicates * references.size();
  KdBuilder(triangles).build(std::move(references), accel.bounds, depth, 0, budget, tree);
  tree.nodes.shrink_to_fit();
  tree.primitives.shrink_to_fit();
  accel.kdNodes = std::move(tree.nodes);
  accel.primitives = std::move(tree.primitives);
}

}  // namespace rc::ddk
