// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_bins-inl.h: where to divide a set of references so that all of each lie on one side: bins along each axis, and
// the surface area heuristic over their borders.
// Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007.
#if defined(RAYCORE_BVH_BINS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_BVH_BINS_INL
#undef RAYCORE_BVH_BINS_INL
#else
#define RAYCORE_BVH_BINS_INL
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
  // Half the surface of what both boxes hold; 0 if they have nothing in common.
  float overlap(const Box8 &other) const {
    float s[3];
    for (size_t axis = 0; axis < 3; ++axis) {
      s[axis] = std::min(v[axis], other.v[axis]) + std::min(v[4 + axis], other.v[4 + axis]);
      if (s[axis] < 0) return 0;
    }
    return s[0] * (s[1] + s[2]) + s[1] * s[2];
  }
};

// References [begin, end), and what is known of them. From `end` to `limit` there is room for more.
struct Range {
  size_t begin, end, limit;
  Box8 box, centres;  // centres: of doubled ones, lower + upper

  size_t count() const { return end - begin; }
};

constexpr size_t kMostBins = 16;

// lower + upper of one axis.
HWY_INLINE float doubledCentre(const BuildReference &reference, size_t axis) {
  return reference.box[4 + axis] - reference.box[axis];
}

// Sizes beyond float, or near nothing, make places that are no numbers.
HWY_INLINE size_t placeIn(size_t count, float place) {
  return static_cast<size_t>(std::min(place > 0 ? place : 0.0f, static_cast<float>(count - 1)));
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
    return placeIn(count, (doubledCentre(reference, axis) - origin[axis]) * scale[axis]);
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
  const uint32_t blocks = (count + hal::TriangleBlock4::kWidth - 1) / hal::TriangleBlock4::kWidth;
  return static_cast<float>(blocks);
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

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
