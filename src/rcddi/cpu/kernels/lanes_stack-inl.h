// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lanes_stack-inl.h: the stack of walks in which 16 rays, or 16 packets, take part side by side: beside each node lies
// where each lane meets its box, so that lanes that have found something nearer drop out one by one.
#if defined(RAYCORE_KERNELS_LANES_STACK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_LANES_STACK_INL
#undef RAYCORE_KERNELS_LANES_STACK_INL
#else
#define RAYCORE_KERNELS_LANES_STACK_INL
#endif

#include <hwy/cache_control.h>

#include "rcddi/cpu/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// A set of triangles on its way through the kernels.
struct Geometry {
  const hal::GeometryView &view;
  uint32_t base;  // number of its first primitive

  // Whether the triangle may let rays through that ask what blocks them.
  bool filters(uint32_t primitive) const {
    return HWY_UNLIKELY(view.filtersShadow) && (view.triangles[primitive].flags & hal::kFiltersShadow) != 0;
  }
};

constexpr size_t kLanes = 16;

struct alignas(64) LanesEntry {
  float near[kLanes];  // infinity: the lane does not meet it
  uint32_t child;      // as in BvhNode8
};

// Where the lanes meet the boxes of a node's children.
struct alignas(64) ChildrenMet {
  float near[hal::BvhNode8::kWidth][kLanes];
  uint32_t met = 0;  // a bit for each child that some lane meets
};

// Lanes that have not yet got as far as `near`. No end of a lane is beyond kFarthest.
HWY_INLINE uint32_t lanesBefore(const float *near, const float *end) {
  const D16 d;
  uint32_t bits = 0;
  for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) {
    bits |= bitsOf(d, hn::Le(hn::Load(d, near + i), hn::Load(d, end + i))) << i;
  }
  return bits;
}

HWY_INLINE void prefetch(const hal::AccelView &accel, uint32_t child) {
  const char *place = child & hal::BvhNode8::kLeaf
                          ? reinterpret_cast<const char *>(&accel.blocks[child & ~hal::BvhNode8::kLeaf])
                          : reinterpret_cast<const char *>(&accel.bvhNodes[child]);
  for (int line = 0; line < 4; ++line) hwy::Prefetch(place + 64 * line);
}

// Puts the children that are met onto the stack, those with the least key last.
HWY_INLINE size_t push(const hal::AccelView &accel, const hal::BvhNode8 &node, const ChildrenMet &children,
                       const float (&keys)[hal::BvhNode8::kWidth], LanesEntry *stack, size_t depth) {
  uint32_t order[hal::BvhNode8::kWidth];
  size_t count = 0;
  for (uint32_t met = children.met; met;) {
    const uint32_t child = nextBit(met);
    prefetch(accel, node.child[child]);
    size_t place = count++;
    for (; place > 0 && keys[order[place - 1]] < keys[child]; --place) order[place] = order[place - 1];
    order[place] = child;
  }
  for (size_t k = 0; k < count; ++k) {
    LanesEntry &entry = stack[depth++];
    std::memcpy(entry.near, children.near[order[k]], sizeof entry.near);
    entry.child = node.child[order[k]];
  }
  return depth;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
