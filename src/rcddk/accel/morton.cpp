// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// morton.cpp: a BVH for one frame: triangles sorted along a space-filling curve, nodes cut where its codes differ.
// Lauterbach, Garland, Sengupta, Luebke, Manocha: "Fast BVH Construction on GPUs", Computer Graphics Forum 28(2), 2009.
// The top of the tree comes first, then its subtrees on all cores: as parts, which are put behind each other.
#include <array>
#include <bit>

#include "rcddk/accel/bvh_parts.h"
#include "rcddk/accel/morton_codes.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

constexpr size_t kCodesAPart = 4096;
// So short ranges are cut where leaves get full. Boxes are larger for it, but a third fewer: measured with bench/trace,
// rays are as fast, and the tree takes 59 bytes a triangle instead of 83.
constexpr size_t kFullLeaves = 64;

// Of the sorted codes.
struct Range {
  size_t begin, end;

  size_t size() const { return end - begin; }
};

// What belongs together: nodes with the names of their children, as in BvhNode8, blocks with those of their triangles.
// All are numbered within the part. A child with this bit is a part of its own, one of `others`.
constexpr uint32_t kOther = 0x40000000;
struct Part {
  std::vector<std::array<uint32_t, BvhNode8::kWidth>> nodes;
  std::vector<std::array<uint32_t, TriangleBlock4::kWidth>> blocks;
  std::vector<Range> others;
};

class PartBuilder {
 public:
  // left: so short ranges are left to other parts.
  PartBuilder(std::span<const Coded> codes, size_t left, Part &out) : mCodes(codes), mLeft(left), mOut(out) {}

  void reserve(size_t codes) {
    mOut.nodes.reserve(codes / 12 + 8);
    mOut.blocks.reserve(codes * 2 / 7 + 8);
  }
  // Appends the subtree of a range and returns its node.
  uint32_t node(const Range &range) {
    size_t borders[BvhNode8::kWidth + 1];
    const uint32_t count = divide(range.begin, range.end, borders);
    const size_t place = mOut.nodes.size();
    mOut.nodes.emplace_back();
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t child = subtree({borders[i], borders[i + 1]});
      mOut.nodes[place][i] = child;  // only now: the subtree may have moved the nodes
    }
    return static_cast<uint32_t>(place);
  }

 private:
  uint32_t subtree(const Range &range) {
    if (range.size() <= TriangleBlock4::kWidth) return leaf(range);
    if (range.size() > mLeft) return node(range);
    mOut.others.push_back(range);
    return static_cast<uint32_t>(mOut.others.size() - 1) | kOther;
  }

  uint32_t leaf(const Range &range) {
    auto &primitives = mOut.blocks.emplace_back();
    primitives.fill(TriangleBlock4::kNone);
    for (size_t i = 0; i < range.size(); ++i) primitives[i] = mCodes[range.begin + i].primitive;
    return static_cast<uint32_t>(mOut.blocks.size() - 1) | BvhNode8::kLeaf;
  }

  // Cuts the child with the most triangles until there are eight, or none is left to cut.
  uint32_t divide(size_t begin, size_t end, size_t *borders) const {
    borders[0] = begin;
    borders[1] = end;
    uint32_t count = 1;
    while (count < BvhNode8::kWidth) {
      uint32_t largest = 0;
      for (uint32_t i = 1; i < count; ++i) {
        if (borders[i + 1] - borders[i] > borders[largest + 1] - borders[largest]) largest = i;
      }
      if (borders[largest + 1] - borders[largest] <= TriangleBlock4::kWidth) break;
      const size_t border = cut(borders[largest], borders[largest + 1]);
      std::copy_backward(borders + largest + 1, borders + count + 1, borders + count + 2);
      borders[largest + 1] = border;
      ++count;
    }
    return count;
  }

  // The number of triangles next to `left` that fills leaves, neither none nor all of `count`.
  static size_t nearestFull(size_t left, size_t count) {
    constexpr size_t kLeaf = TriangleBlock4::kWidth;
    return std::clamp((left + kLeaf / 2) / kLeaf * kLeaf, kLeaf, (count - 1) / kLeaf * kLeaf);
  }

  // Where the highest bit changes that not all codes of the range have in common; the middle if they are equal.
  size_t cut(size_t begin, size_t end) const {
    const uint32_t different = mCodes[begin].code ^ mCodes[end - 1].code;
    size_t left = (end - begin) / 2;
    if (different != 0) {
      const uint32_t bit = std::bit_floor(different);
      const auto range = mCodes.subspan(begin, end - begin);
      const auto place =
          std::partition_point(range.begin(), range.end(), [&](const Coded &c) { return !(c.code & bit); });
      left = static_cast<size_t>(place - range.begin());
    }
    return begin + (end - begin <= kFullLeaves ? nearestFull(left, end - begin) : left);
  }

  std::span<const Coded> mCodes;
  size_t mLeft;
  Part &mOut;
};

// The first one is the top of the tree; behind it lie its others.
std::vector<Part> partsOf(std::span<const Coded> codes, const Workers &workers) {
  std::vector<Part> parts(1);
  PartBuilder(codes, kCodesAPart, parts[0]).node({0, codes.size()});
  const std::vector<Range> ranges = parts[0].others;
  parts.resize(1 + ranges.size());
  workers.forEach(ranges.size(), [&](size_t i, int) {
    PartBuilder part(codes, 0, parts[1 + i]);
    part.reserve(ranges[i].size());
    part.node(ranges[i]);
  });
  return parts;
}

// Where the nodes and blocks of a part begin in the whole tree.
struct PartPlace {
  uint32_t node = 0, block = 0;
};

void putPart(const Part &part, const PartPlace &place, std::span<const PartPlace> others, Accel &out) {
  const auto nameOf = [&](uint32_t child) {
    if (child & BvhNode8::kLeaf) return child + place.block;
    return child & kOther ? others[child & ~kOther].node : child + place.node;
  };
  for (size_t n = 0; n < part.nodes.size(); ++n) {
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const uint32_t child = part.nodes[n][i];
      setChild(out.bvhNodes[place.node + n], i, Bounds(), child ? nameOf(child) : 0);
    }
  }
  for (size_t b = 0; b < part.blocks.size(); ++b) {
    std::ranges::copy(part.blocks[b], out.blocks[place.block + b].primitive);
  }
}

}  // namespace

void buildMorton(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  const LargeVector<Coded> codes = sortedCodes(triangles, accel.core, workers);
  const std::vector<Part> parts = partsOf(codes, workers);
  std::vector<PartPlace> places;
  PartPlace end;
  for (const Part &part : parts) {
    places.push_back(end);
    end.node += static_cast<uint32_t>(part.nodes.size());
    end.block += static_cast<uint32_t>(part.blocks.size());
  }
  accel.bvhNodes.resize(end.node);
  accel.blocks.resize(end.block);
  workers.forEach(parts.size(),
                  [&](size_t i, int) { putPart(parts[i], places[i], std::span(places).subspan(1), accel); });
  fit(triangles, workers, accel);
}

}  // namespace rc::ddk
