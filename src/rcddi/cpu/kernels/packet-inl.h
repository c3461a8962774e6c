// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// packet-inl.h: triangles against the rays of a packet: the watertight test of units/intersection.h, operation
// by operation, so that hits are equal to the last bit. No multiplication is fused with an addition here.
#if defined(RAYCORE_KERNELS_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_PACKET_INL
#undef RAYCORE_KERNELS_PACKET_INL
#else
#define RAYCORE_KERNELS_PACKET_INL
#endif

#include "rcddi/cpu/kernels/batch-inl.h"
#include "rcddi/cpu/kernels/lanes_stack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// A vertex as seen from the origins of rays, sheared.
template <class V>
struct Corner {
  V x, y, z;
};

// Up to 16 triangles, from four blocks.
struct alignas(64) TriangleLanes {
  float corners[3][3][kLanes];  // by vertex, along kx, ky, kz; less the origin if the batch has a common one
  uint32_t primitive[kLanes];   // through both sets; TriangleBlock4::kNone: there is none
};

constexpr size_t kBlocks = kLanes / hal::TriangleBlock4::kWidth;
using Blocks = const hal::TriangleBlock4 *[kBlocks];

// The lanes from `first` on of what four values of each block are. As whole vectors: one that is put together in memory
// would be waited for when it is read.
template <class D, class Values>
HWY_INLINE hn::Vec<D> loadLanes(D d, const Blocks &blocks, size_t first, Values &&values) {
  constexpr size_t kWidth = hal::TriangleBlock4::kWidth;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(D()) > kWidth) {
    const hn::Half<D> half;
    return hn::Combine(d, loadLanes(half, blocks, first + hn::MaxLanes(half), values),
                       loadLanes(half, blocks, first, values));
  }
#endif
  return hn::LoadU(d, values(*blocks[first / kWidth]) + first % kWidth);
}

// The triangles of four blocks.
HWY_INLINE void setTriangles(const Geometry &geometry, const Blocks &blocks, const Batch &batch, TriangleLanes &out) {
  using Block = hal::TriangleBlock4;
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) {
    for (size_t k = 0; k < 3; ++k) {
      const auto origin = hn::Set(d, batch.common ? batch.origin[axes[k]][0] : 0.0f);
      for (size_t v = 0; v < 3; ++v) {
        const auto values = [&](const Block &block) HWY_ATTR { return block.vertices[v][axes[k]]; };
        hn::Store(hn::Sub(loadLanes(d, blocks, i, values), origin), d, out.corners[v][k] + i);
      }
    }
    const auto primitive = loadLanes(du, blocks, i, [](const Block &block) HWY_ATTR { return block.primitive; });
    const auto none = hn::Set(du, Block::kNone), number = hn::Add(primitive, hn::Set(du, geometry.base));
    hn::Store(hn::IfThenElse(hn::Eq(primitive, none), none, number), du, out.primitive + i);
  }
}

// A triangle as the first of the lanes.
template <bool kCommon>
HWY_INLINE void setTriangle(const Geometry &geometry, const Batch &batch, uint32_t primitive, TriangleLanes &out) {
  const hal::HotTriangle &triangle = geometry.view.triangles[primitive];
  const Vec3 *vertices[] = {&triangle.v0, &triangle.v1, &triangle.v2};
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  for (size_t k = 0; k < 3; ++k) {
    const float origin = kCommon ? batch.origin[axes[k]][0] : 0;
    for (size_t v = 0; v < 3; ++v) out.corners[v][k][0] = (*vertices[v])[axes[k]] - origin;
  }
  out.primitive[0] = geometry.base + primitive;
}

template <bool kCommon>
HWY_INLINE Corner<hn::Vec<D16>> shear(const Batch &batch, const float (&vertex)[3][kLanes], size_t lane, size_t i) {
  const D16 d;
  auto x = hn::Set(d, vertex[0][lane]), y = hn::Set(d, vertex[1][lane]), z = hn::Set(d, vertex[2][lane]);
  if constexpr (!kCommon) {
    x = hn::Sub(x, hn::LoadU(d, batch.origin[batch.kx] + i));
    y = hn::Sub(y, hn::LoadU(d, batch.origin[batch.ky] + i));
    z = hn::Sub(z, hn::LoadU(d, batch.origin[batch.kz] + i));
  }
  return {hn::Sub(x, hn::Mul(hn::Load(d, batch.sx + i), z)), hn::Sub(y, hn::Mul(hn::Load(d, batch.sy + i), z)), z};
}

// On which side of a triangle's edges a ray goes by, from the least and the most of the three edge functions: above 0
// inside, below 0 outside. 0: it meets an edge as exactly as float can tell, or all three are tiny; the scalar unit
// decides.
template <class V>
HWY_INLINE V sideOf(V least, V most) {
  return hn::Mul(least, most);
}

// Whether a hit comes before what the ray has.
HWY_INLINE bool improves(const Batch &batch, size_t i, const hal::Hit &hit) {
  return hal::HitOrder{} < hal::HitOrder{hit.t, hit.primitive} &&
         hal::HitOrder{hit.t, hit.primitive} < hal::HitOrder{batch.t[i], batch.primitive[i]};
}

HWY_INLINE void record(Batch &batch, size_t i, const hal::Hit &hit) {
  batch.t[i] = hit.t;
  batch.u[i] = hit.u;
  batch.v[i] = hit.v;
  batch.primitive[i] = hit.primitive;
}

// A hit before the end of a ray that asks what blocks it. Returns whether the ray needs no more.
HWY_INLINE bool blockRay(const Geometry &geometry, Batch &batch, size_t i, uint32_t primitive, const hal::Hit &hit) {
  if (geometry.filters(primitive)) {
    const hal::Passage passage =
        hal::passageOf(geometry.view, primitive, batch.reach.towardsLight(batch.ray(i).direction));
    if (passage == hal::Passage::Free) return false;
    const bool noted = passage == hal::Passage::Filtered;
    if (noted && (!batch.filters || i >= batch.rays || batch.filters->note(batch.place(i), hit))) return false;
  }
  batch.t[i] = -kInfinity;
  return true;
}

// The same for the rays from `first` on whose lanes are set.
HWY_NOINLINE void blockRays(const Geometry &geometry, Batch &batch, size_t first, uint32_t lanes, uint32_t primitive,
                            const float *t, const float *u, const float *v) {
  while (lanes) {
    const uint32_t lane = nextBit(lanes);
    blockRay(geometry, batch, first + lane, primitive, {t[lane], u[lane], v[lane], geometry.base + primitive});
  }
}

// The scalar unit for the rays from `first` on whose lanes are set.
template <bool kAny>
HWY_NOINLINE void intersectOnEdge(const Geometry &geometry, Batch &batch, uint32_t primitive, size_t first,
                                  uint32_t lanes) {
  while (lanes) {
    const size_t i = first + nextBit(lanes);
    hal::Hit hit;
    if (!hal::intersectTriangle(hal::ShearedRay(batch.ray(i)), geometry.view.triangles[primitive], hit)) continue;
    hit.primitive = geometry.base + primitive;
    if constexpr (kAny) {
      if (hit.t > batch.reach.begin && hit.t < batch.t[i]) blockRay(geometry, batch, i, primitive, hit);
    } else if (improves(batch, i, hit)) {
      record(batch, i, hit);
    }
  }
}

// One triangle against the rays from i on. There is no early end: whether rays meet what their window does, or have met
// something nearer, cannot be foretold.
template <bool kAny, bool kCommon>
HWY_INLINE void intersectTriangle(const Geometry &geometry, Batch &batch, const TriangleLanes &triangles, size_t lane,
                                  size_t i) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  const auto zero = hn::Zero(d);
  const auto a = shear<kCommon>(batch, triangles.corners[0], lane, i);
  const auto b = shear<kCommon>(batch, triangles.corners[1], lane, i);
  const auto c = shear<kCommon>(batch, triangles.corners[2], lane, i);
  const auto wa = hn::Sub(hn::Mul(c.x, b.y), hn::Mul(c.y, b.x));
  const auto wb = hn::Sub(hn::Mul(a.x, c.y), hn::Mul(a.y, c.x));
  const auto wc = hn::Sub(hn::Mul(b.x, a.y), hn::Mul(b.y, a.x));
  const auto least = hn::Min(hn::Min(wa, wb), wc), most = hn::Max(hn::Max(wa, wb), wc);
  const auto side = sideOf(least, most);
  const auto onEdge = hn::Eq(side, zero), inside = hn::Gt(side, zero);
  if (HWY_UNLIKELY(!hn::AllFalse(d, onEdge))) {
    intersectOnEdge<kAny>(geometry, batch, triangles.primitive[lane] - geometry.base, i, bitsOf(d, onEdge));
  }
  const auto primitive = hn::Set(du, triangles.primitive[lane]);
  const auto scale = hn::Div(hn::Set(d, 1.0f), hn::Add(hn::Add(wa, wb), wc));
  const auto height = hn::Add(hn::Add(hn::Mul(wa, a.z), hn::Mul(wb, b.z)), hn::Mul(wc, c.z));
  const auto t = hn::Mul(hn::Mul(height, hn::Load(d, batch.sz + i)), scale);
  const auto best = hn::Load(d, batch.t + i);
  auto better = hn::Lt(t, best);
  if constexpr (!kAny) {
    const auto lower = hn::Lt(primitive, hn::Load(du, batch.primitive + i));
    better = hn::Or(better, hn::And(hn::Eq(t, best), hn::RebindMask(d, lower)));
  }
  const auto accept = hn::And(inside, hn::And(hn::Gt(t, kAny ? hn::Set(d, batch.reach.begin) : zero), better));
  const auto u = hn::Mul(wb, scale), v = hn::Mul(wc, scale);
  if constexpr (kAny) {
    const uint32_t inSet = triangles.primitive[lane] - geometry.base;
    if (geometry.filters(inSet)) {
      if (hn::AllFalse(d, accept)) return;
      alignas(64) float lanes[3][kLanes];
      hn::Store(t, d, lanes[0]);
      hn::Store(u, d, lanes[1]);
      hn::Store(v, d, lanes[2]);
      return blockRays(geometry, batch, i, bitsOf(d, accept), inSet, lanes[0], lanes[1], lanes[2]);
    }
    hn::Store(hn::IfThenElse(accept, hn::Set(d, -kInfinity), best), d, batch.t + i);
  } else {
    hn::Store(hn::IfThenElse(accept, t, best), d, batch.t + i);
    storeWhere(d, accept, u, batch.u + i);
    storeWhere(d, accept, v, batch.v + i);
    storeWhere(du, hn::RebindMask(du, accept), primitive, batch.primitive + i);
  }
}

// One triangle against a packet.
template <bool kAny, bool kCommon>
HWY_INLINE void intersectPacket(const Geometry &geometry, Batch &batch, const TriangleLanes &triangles, size_t lane,
                                size_t packet) {
  for (size_t i = 0; i < kPacketRays; i += hn::Lanes(D16())) {
    intersectTriangle<kAny, kCommon>(geometry, batch, triangles, lane, packet * kPacketRays + i);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
