// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// morton.cpp: a BVH for one frame: triangles sorted along a space-filling curve, nodes cut where its codes differ.
// Lauterbach, Garland, Sengupta, Luebke, Manocha: "Fast BVH Construction on GPUs", Computer Graphics Forum 28(2), 2009.
#include <array>

#include "rcddk/accel/bvh_parts.h"

namespace rc::ddk {
namespace {

using hal::BvhNode8;
using hal::HotTriangle;
using hal::TriangleBlock4;

constexpr int kBitsAnAxis = 10;
constexpr size_t kCodesATask = 4096;

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

Bounds boxOf(const HotTriangle &t) {
  const float margin = boxMargin(t);
  return {glm::min(t.v0, glm::min(t.v1, t.v2)) - margin, glm::max(t.v0, glm::max(t.v1, t.v2)) + margin};
}

Bounds boundsOf(std::span<const HotTriangle> triangles, const Workers &workers) {
  std::vector<Bounds> parts((triangles.size() + kCodesATask - 1) / kCodesATask);
  workers.forEach(parts.size(), [&](size_t task, int) {
    const size_t first = task * kCodesATask;
    for (const HotTriangle &t : triangles.subspan(first, std::min(kCodesATask, triangles.size() - first))) {
      parts[task].add(boxOf(t));
    }
  });
  Bounds all;
  for (const Bounds &part : parts) all.add(part);
  return all;
}

std::vector<Coded> codesOf(std::span<const HotTriangle> triangles, const Bounds &bounds, const Workers &workers) {
  std::vector<Coded> codes(triangles.size());
  const Vec3 size = glm::max(bounds.size(), Vec3(1e-30f));
  constexpr float kCells = 1 << kBitsAnAxis;
  workers.forEach((codes.size() + kCodesATask - 1) / kCodesATask, [&](size_t task, int) {
    for (size_t i = task * kCodesATask; i < std::min(codes.size(), (task + 1) * kCodesATask); ++i) {
      const Vec3 cell = glm::clamp((boxOf(triangles[i]).centre() - bounds.lower) / size * kCells, 0.0f, kCells - 1);
      const auto bits = [](float x) { return spread(static_cast<uint32_t>(x)); };
      codes[i] = {bits(cell.x) << 2 | bits(cell.y) << 1 | bits(cell.z), static_cast<uint32_t>(i)};
    }
  });
  return codes;
}

// By code, equal ones in the order they came in: least significant digits first.
void sortByCode(std::vector<Coded> &codes) {
  constexpr size_t kDigit = 1 << kBitsAnAxis;
  std::vector<Coded> other(codes.size());
  for (int shift = 0; shift < 3 * kBitsAnAxis; shift += kBitsAnAxis) {
    std::array<uint32_t, kDigit + 1> places{};
    for (const Coded &c : codes) ++places[(c.code >> shift) % kDigit + 1];
    for (size_t i = 1; i < kDigit; ++i) places[i] += places[i - 1];
    for (const Coded &c : codes) other[places[(c.code >> shift) % kDigit]++] = c;
    codes.swap(other);
  }
}

class MortonBuilder {
 public:
  MortonBuilder(std::span<const Coded> codes, std::span<const HotTriangle> triangles)
      : mCodes(codes), mTriangles(triangles) {}

  // Appends the subtree of codes [begin, end) and returns its node; `box` becomes its bounds.
  uint32_t node(size_t begin, size_t end, BvhPieces &out, Bounds &box) const {
    size_t borders[BvhNode8::kWidth + 1];
    const uint32_t count = divide(begin, end, borders);
    const auto place = static_cast<uint32_t>(out.nodes.size());
    out.nodes.emplace_back();
    std::array<Bounds, BvhNode8::kWidth> boxes;
    uint32_t names[BvhNode8::kWidth] = {};
    if (end - begin >= kParallelReferences) {
      std::array<BvhPieces, BvhNode8::kWidth> pieces;
      parallel(borders, 0, count, pieces, names, boxes);
      for (uint32_t i = 0; i < count; ++i) names[i] = out.append(pieces[i], names[i]);
    } else {
      for (uint32_t i = 0; i < count; ++i) names[i] = subtree(borders[i], borders[i + 1], out, boxes[i]);
    }
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      setChild(out.nodes[place], i, boxes[i], names[i]);
      box.add(boxes[i]);
    }
    return place;
  }

 private:
  uint32_t subtree(size_t begin, size_t end, BvhPieces &out, Bounds &box) const {
    if (end - begin > TriangleBlock4::kWidth) return node(begin, end, out, box);
    TriangleBlock4 &block = out.blocks.emplace_back();
    for (uint32_t lane = 0; lane < TriangleBlock4::kWidth; ++lane) {
      const bool used = begin + lane < end;
      const uint32_t primitive = mCodes[used ? begin + lane : begin].primitive;
      setLane(block, lane, mTriangles[primitive]);
      block.primitive[lane] = used ? primitive : TriangleBlock4::kNone;
      box.add(boxOf(mTriangles[primitive]));
    }
    return static_cast<uint32_t>(out.blocks.size() - 1) | BvhNode8::kLeaf;
  }

  void parallel(const size_t *borders, uint32_t first, uint32_t last, std::array<BvhPieces, BvhNode8::kWidth> &pieces,
                uint32_t *names, std::array<Bounds, BvhNode8::kWidth> &boxes) const {
    if (last - first == 1) {
      pieces[first].reserve(borders[last] - borders[first]);
      names[first] = subtree(borders[first], borders[last], pieces[first], boxes[first]);
      return;
    }
    const uint32_t middle = (first + last) / 2;
    both([&] { parallel(borders, first, middle, pieces, names, boxes); },
         [&] { parallel(borders, middle, last, pieces, names, boxes); });
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

  // Where the highest bit changes that not all codes of the range have in common; the middle if they are equal.
  size_t cut(size_t begin, size_t end) const {
    const uint32_t different = mCodes[begin].code ^ mCodes[end - 1].code;
    if (different == 0) return begin + (end - begin) / 2;
    const uint32_t bit = std::bit_floor(different);
    const auto range = mCodes.subspan(begin, end - begin);
    const auto place =
        std::partition_point(range.begin(), range.end(), [&](const Coded &c) { return !(c.code & bit); });
    return begin + static_cast<size_t>(place - range.begin());
  }

  std::span<const Coded> mCodes;
  std::span<const HotTriangle> mTriangles;
};

}  // namespace

void buildMorton(std::span<const HotTriangle> triangles, const Workers &workers, Accel &accel) {
  const Bounds bounds = boundsOf(triangles, workers);
  std::vector<Coded> codes = codesOf(triangles, bounds, workers);
  sortByCode(codes);
  BvhPieces pieces;
  pieces.reserve(triangles.size());
  workers.run([&] { MortonBuilder(codes, triangles).node(0, codes.size(), pieces, accel.bounds); });
  accel.bvhNodes = std::move(pieces.nodes);
  accel.blocks = std::move(pieces.blocks);
}

}  // namespace rc::ddk
