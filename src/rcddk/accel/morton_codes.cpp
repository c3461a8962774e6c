// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/morton_codes.h"

#include <array>
#include <utility>

#include "rcddk/accel/bvh_parts.h"
#include "rcddk/accel/float4.h"

namespace rc::ddk {
namespace {

using hal::HotTriangle;

constexpr int kBitsAnAxis = 10;
constexpr size_t kCodesATask = 4096;

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
  forEachShare(workers, triangles.size(), kCodesATask, [&](size_t task, size_t begin, size_t end) {
    Box box = boxOf(triangles[begin]);
    for (const HotTriangle &t : triangles.subspan(begin, end - begin)) {
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
  forEachShare(workers, codes.size(), kCodesATask, [&](size_t, size_t begin, size_t end) {
    const Float4 factor{scale.x, scale.y, scale.z, 0}, start{origin.x, origin.y, origin.z, 0};
    for (size_t i = begin; i < end; ++i) {
      const Box box = boxOf(triangles[i]);
      const Float4 cell = min(max((box.lower + box.upper - start) * factor, all(0)), all(kCells - 1));
      const auto bits = [&](int axis) { return spread(static_cast<uint32_t>(cell[axis])); };
      codes[i] = {bits(0) << 2 | bits(1) << 1 | bits(2), static_cast<uint32_t>(i)};
    }
  });
  return codes;
}

// Least significant digits first. Each task puts its codes behind those of the tasks before it.
void sortByCode(LargeVector<Coded> &codes, const Workers &workers) {
  constexpr size_t kDigits = 1 << kBitsAnAxis, kShare = 4 * kCodesATask;
  LargeVector<Coded> other(codes.size());
  std::vector<std::array<uint32_t, kDigits>> places((codes.size() + kShare - 1) / kShare);
  for (int shift = 0; shift < 3 * kBitsAnAxis; shift += kBitsAnAxis) {
    const auto forEachCode = [&](auto &&visit) {
      forEachShare(workers, codes.size(), kShare, [&](size_t task, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) visit(codes[i], places[task][(codes[i].code >> shift) % kDigits]);
      });
    };
    for (auto &counts : places) counts.fill(0);
    forEachCode([](const Coded &, uint32_t &count) { ++count; });
    uint32_t before = 0;
    for (size_t digit = 0; digit < kDigits; ++digit) {
      for (auto &counts : places) before += std::exchange(counts[digit], before);
    }
    forEachCode([&](const Coded &code, uint32_t &place) { other[place++] = code; });
    codes.swap(other);
  }
}

}  // namespace

LargeVector<Coded> sortedCodes(std::span<const HotTriangle> triangles, const Bounds &core, const Workers &workers) {
  LargeVector<Coded> codes = codesOf(triangles, cellsOf(boundsOf(triangles, workers), core), workers);
  sortByCode(codes, workers);
  return codes;
}

}  // namespace rc::ddk
