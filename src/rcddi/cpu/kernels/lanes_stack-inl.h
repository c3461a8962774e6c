// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lanes_stack-inl.h: the stack of walks in which the rays of a packet, or the packets of a beam, take part side by
// side: beside each node lies where each of them meets its box, so that those that have found something nearer drop out
// one by one.
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

// For so many that take part.
template <size_t kCount>
struct alignas(64) LanesEntryOf {
  float near[kCount];  // infinity: the lane does not meet it
  uint32_t child;      // as in BvhNode8
};
using LanesEntry = LanesEntryOf<kLanes>;

// Lanes that have not yet got as far as `near`. No end of a lane is beyond kFarthest.
template <size_t kCount>
HWY_INLINE uint32_t lanesBefore(const float (&near)[kCount], const float *end) {
  const D16 d;
  uint32_t bits = 0;
  for (size_t i = 0; i < kCount; i += hn::Lanes(d)) {
    bits |= bitsOf(d, hn::Le(hn::Load(d, near + i), hn::Load(d, end + i))) << i;
  }
  return bits;
}

// Computed without a branch: which kind a child is, cannot be foretold.
HWY_INLINE void prefetch(const hal::AccelView &accel, uint32_t child) {
  const auto nodes = reinterpret_cast<uintptr_t>(accel.bvhNodes.data());
  const auto blocks = reinterpret_cast<uintptr_t>(accel.blocks.data());
  const uintptr_t leaf = child / hal::BvhNode8::kLeaf;  // 0 or 1
  const uintptr_t size = sizeof(hal::BvhNode8) - leaf * (sizeof(hal::BvhNode8) - sizeof(hal::TriangleBlock4));
  const uintptr_t place = nodes + (blocks - nodes) * leaf + (child & ~hal::BvhNode8::kLeaf) * size;
  for (uintptr_t line = 0; line < 4; ++line) hwy::Prefetch(reinterpret_cast<const char *>(place + 64 * line));
}

// How many of the children whose bits are set lie beneath this one on a stack that has the least key on top. Theirs are
// numbers.
HWY_INLINE size_t countBeneath(const float (&keys)[hal::BvhNode8::kWidth], uint32_t bits, uint32_t child) {
  const D8 d;
  const auto key = hn::Set(d, keys[child]);
  uint32_t greater = 0, equal = 0;
  for (size_t i = 0; i < hal::BvhNode8::kWidth; i += hn::Lanes(d)) {
    const auto others = hn::Load(d, keys + i);
    greater |= bitsOf(d, hn::Gt(others, key)) << i;
    equal |= bitsOf(d, hn::Eq(others, key)) << i;
  }
  return hwy::PopCount(bits & (greater | (equal & ((1u << child) - 1))));
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
