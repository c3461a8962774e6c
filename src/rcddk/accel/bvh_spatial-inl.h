// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh_spatial-inl.h: where to cut a set of references by a plane: triangles that it crosses become two references,
// each with the box of its part. Long triangles askew then no longer stretch the boxes of all around them.
// Stich, Friedrich, Dietrich: "Spatial Splits in Bounding Volume Hierarchies", HPG 2009.
#if defined(RAYCORE_BVH_SPATIAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_BVH_SPATIAL_INL
#undef RAYCORE_BVH_SPATIAL_INL
#else
#define RAYCORE_BVH_SPATIAL_INL
#endif

#include "rcddk/accel/bvh_bins-inl.h"
#include "rcddk/accel/cut.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddk::HWY_NAMESPACE {

constexpr size_t kSlabs = 16;

// The range's box in slabs along each axis.
struct Slabs {
  float origin[3], width[3], scale[3];

  explicit Slabs(const Box8 &box) {
    for (size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = -box.v[axis];
      width[axis] = box.size(axis) / kSlabs;
      scale[axis] = width[axis] > 0 ? 1 / width[axis] : 0;
    }
  }
  HWY_INLINE size_t slabOf(float x, size_t axis) const {
    return placeIn(kSlabs, (x - origin[axis]) * scale[axis]);
  }
  float border(size_t axis, size_t slab) const { return origin[axis] + width[axis] * static_cast<float>(slab); }
  // The slabs that the reference reaches into.
  HWY_INLINE size_t first(const BuildReference &r, size_t axis) const { return slabOf(-r.box[axis], axis); }
  HWY_INLINE size_t last(const BuildReference &r, size_t axis) const { return slabOf(r.box[4 + axis], axis); }
};

// What references have inside each slab, and how many begin and end there.
struct SlabBins {
  Box8 boxes[3][kSlabs];
  uint32_t begins[3][kSlabs] = {}, ends[3][kSlabs] = {};
};

struct Halves {
  BuildReference below, above;
  bool hasBelow, hasAbove;
};
inline Halves cut(const hal::HotTriangle &triangle, const BuildReference &reference, size_t axis, float position) {
  const CutBoxes boxes = ddk::cut(triangle, reference.bounds(), static_cast<int>(axis), position);
  return {{boxes.below, reference.primitive()},
          {boxes.above, reference.primitive()},
          !boxes.below.empty(),
          !boxes.above.empty()};
}

inline void fill(std::span<const BuildReference> references, std::span<const hal::HotTriangle> triangles,
                 const Slabs &slabs, SlabBins &bins) {
  for (const BuildReference &reference : references) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const size_t first = slabs.first(reference, axis), last = slabs.last(reference, axis);
      ++bins.begins[axis][first];
      ++bins.ends[axis][last];
      BuildReference rest = reference;
      bool some = true;
      for (size_t slab = first; slab < last && some; ++slab) {
        const Halves halves = cut(triangles[reference.primitive()], rest, axis, slabs.border(axis, slab + 1));
        if (halves.hasBelow) bins.boxes[axis][slab].add(halves.below.box);
        rest = halves.above;
        some = halves.hasAbove;
      }
      if (some) bins.boxes[axis][last].add(rest.box);
    }
  }
}

struct SpatialSplit {
  size_t axis = 3, slab = 0;   // slabs below go left; axis 3: none
  size_t left = 0, right = 0;  // references on each side
  float cost = kInfinity;
};

HWY_INLINE void evaluate(const SlabBins &bins, size_t axis, SpatialSplit &best) {
  float rightCost[kSlabs];
  uint32_t right[kSlabs];
  Box8 box;
  uint32_t n = 0;
  for (size_t i = kSlabs - 1; i > 0; --i) {
    box.add(bins.boxes[axis][i].v);
    right[i] = n += bins.ends[axis][i];
    rightCost[i] = n ? box.halfArea() * blocksOf(n) : kInfinity;
  }
  box = {};
  n = 0;
  for (size_t i = 1; i < kSlabs; ++i) {
    box.add(bins.boxes[axis][i - 1].v);
    n += bins.begins[axis][i - 1];
    if (n == 0) continue;
    const float cost = box.halfArea() * blocksOf(n) + rightCost[i];
    if (cost < best.cost) best = {axis, i, n, right[i], cost};
  }
}

inline SpatialSplit bestPlane(std::span<const BuildReference> references, std::span<const hal::HotTriangle> triangles,
                              const Slabs &slabs) {
  SlabBins bins;
  fill(references, triangles, slabs, bins);
  SpatialSplit best;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (slabs.scale[axis] > 0) evaluate(bins, axis, best);
  }
  return best;
}

struct Parts {
  Array<BuildReference> left, right;
};

inline Parts partsOf(std::span<const BuildReference> references, std::span<const hal::HotTriangle> triangles,
                     const Slabs &slabs, const SpatialSplit &split) {
  Parts out;
  const float position = slabs.border(split.axis, split.slab);
  for (const BuildReference &reference : references) {
    if (slabs.last(reference, split.axis) < split.slab) {
      out.left.push_back(reference);
    } else if (slabs.first(reference, split.axis) >= split.slab) {
      out.right.push_back(reference);
    } else {
      const Halves halves = cut(triangles[reference.primitive()], reference, split.axis, position);
      if (halves.hasBelow) out.left.push_back(halves.below);
      if (halves.hasAbove) out.right.push_back(halves.above);
    }
  }
  return out;
}

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
