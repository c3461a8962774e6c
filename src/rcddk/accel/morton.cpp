// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// morton.cpp: a BVH for one frame: triangles sorted along a space-filling curve, nodes cut where its codes differ.
// Lauterbach, Garland, Sengupta, Luebke, Manocha: "Fast BVH Construction on GPUs", Computer Graphics Forum 28(2), 2009.
#include <array>

#include "rcddk/accel/bvh_parts.h"
#include "rcddk/accel/float4.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

constexpr int kBitsAnAxis = 10;
constexpr size_t kCodesATask = 4096;
// So short ranges are cut where leaves get full. Boxes are larger for it, but a third fewer: measured with bench/trace,
// rays are as fast, and the tree takes 59 bytes a triangle instead of 83.
constexpr size_t kFullLeaves = 64;

struct Coded {
  uint32_t code, primitive;
};

// Puts two zeros between the bits.
uint32_t spread(uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

// The box of a triangle without its margin; the fourth lanes are of no meaning.
struct Box {
  Float4 lower, upper;
};
Box boxOf(const HotTriangle &t) {
  const auto *bytes = reinterpret_cast<const char *>(&t);
  const Float4 a = load4(bytes), b = load4(bytes + sizeof(Vec3)), c = load4(bytes + 2 * sizeof(Vec3));
  return {min(min(a, b), c), max(max(a, b), c)};
}

Bounds boundsOf(std::span<const HotTriangle> triangles, const Workers &workers) {
  Array<Bounds> parts((triangles.size() + kCodesATask - 1) / kCodesATask);
  workers.forEach(parts.size(), [&](size_t task, int) {
    const size_t first = task * kCodesATask;
    Box box = boxOf(triangles[first]);
    for (const HotTriangle &t : triangles.subspan(first, std::min(kCodesATask, triangles.size() - first))) {
      const Box other = boxOf(t);
      box = {min(box.lower, other.lower), max(box.upper, other.upper)};
    }
    const Float4 lower = box.lower, upper = box.upper;
    parts[task] = {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
  });
  Bounds all;
  for (const Bounds &part : parts) all.add(part);
  return all;
}

// What the cells divide: where most triangles are, and as far again around. What lies beyond is in the outermost cells:
// else one triangle far away would put all the others into one.
Bounds cellsOf(const Bounds &all, const Bounds &core) {
  const Vec3 around(maxComponent(core.size()));
  return intersection(all, {core.lower - around, core.upper + around});
}

LargeVector<Coded> codesOf(std::span<const HotTriangle> triangles, const Bounds &bounds, const Workers &workers) {
  LargeVector<Coded> codes(triangles.size());
  constexpr float kCells = 1 << kBitsAnAxis;
  const Vec3 scale = 0.5f * kCells / glm::max(bounds.size(), Vec3(1e-30f)), origin = 2.0f * bounds.lower;
  workers.forEach((codes.size() + kCodesATask - 1) / kCodesATask, [&](size_t task, int) {
    const Float4 factor{scale.x, scale.y, scale.z, 0}, start{origin.x, origin.y, origin.z, 0};
    for (size_t i = task * kCodesATask; i < std::min(codes.size(), (task + 1) * kCodesATask); ++i) {
      const Box box = boxOf(triangles[i]);
      const Float4 cell = min(max((box.lower + box.upper - start) * factor, all(0)), all(kCells - 1));
      const auto bits = [&](int axis) { return spread(static_cast<uint32_t>(cell[axis])); };
      codes[i] = {bits(0) << 2 | bits(1) << 1 | bits(2), static_cast<uint32_t>(i)};
    }
  });
  return codes;
}

// By code, equal ones in the order they came in: least significant digits first.
void sortByCode(LargeVector<Coded> &codes) {
  constexpr size_t kDigit = 1 << kBitsAnAxis;
  LargeVector<Coded> other(codes.size());
  for (int shift = 0; shift < 3 * kBitsAnAxis; shift += kBitsAnAxis) {
    std::array<uint32_t, kDigit + 1> places{};
    for (const Coded &c : codes) ++places[(c.code >> shift) % kDigit + 1];
    for (size_t i = 1; i < kDigit; ++i) places[i] += places[i - 1];
    for (const Coded &c : codes) other[places[(c.code >> shift) % kDigit]++] = c;
    codes.swap(other);
  }
}

// What belongs together: nodes with the names of their children, blocks with those of their triangles. Boxes come
// later.
class MortonBuilder {
 public:
  MortonBuilder(std::span<const Coded> codes, Accel &out) : mCodes(codes), mOut(out) {}

  // Appends the subtree of codes [begin, end) and returns its node.
  uint32_t node(size_t begin, size_t end) {
    size_t borders[BvhNode8::kWidth + 1];
    const uint32_t count = divide(begin, end, borders);
    const auto place = static_cast<uint32_t>(mOut.bvhNodes.size());
    mOut.bvhNodes.emplace_back();
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const uint32_t child = i < count ? subtree(borders[i], borders[i + 1]) : 0;
      setChild(mOut.bvhNodes[place], i, Bounds(), child);  // only now: the subtree may have moved the nodes
    }
    return place;
  }

 private:
  uint32_t subtree(size_t begin, size_t end) {
    if (end - begin > TriangleBlock4::kWidth) return node(begin, end);
    TriangleBlock4 &block = mOut.blocks.emplace_back();
    for (size_t lane = 0; lane < TriangleBlock4::kWidth; ++lane) {
      block.primitive[lane] = begin + lane < end ? mCodes[begin + lane].primitive : TriangleBlock4::kNone;
    }
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
  Accel &mOut;
};

}  // namespace

void buildMorton(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  LargeVector<Coded> codes = codesOf(triangles, cellsOf(boundsOf(triangles, workers), accel.core), workers);
  sortByCode(codes);
  accel.bvhNodes.reserve(triangles.size() / 12 + 8);
  accel.blocks.reserve(triangles.size() * 2 / 7 + 8);
  MortonBuilder(codes, accel).node(0, codes.size());
  fit(triangles, workers, accel);
}

}  // namespace rc::ddk
