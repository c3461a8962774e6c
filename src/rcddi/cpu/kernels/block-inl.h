// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// block-inl.h: the triangles of a leaf against rays that go their own ways: one ray at a time, or four where vectors
// have 16 lanes. The test is that of units/intersection.h, operation by operation; see packet-inl.h.
#if defined(RAYCORE_KERNELS_BLOCK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_BLOCK_INL
#undef RAYCORE_KERNELS_BLOCK_INL
#else
#define RAYCORE_KERNELS_BLOCK_INL
#endif

#include "rcddi/cpu/kernels/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

constexpr size_t kBlockWidth = hal::TriangleBlock4::kWidth;

// What the test of a block finds: four lanes for each ray.
struct alignas(64) BlockHits {
  float t[kLanes], u[kLanes], v[kLanes];
  uint32_t onEdge;  // lanes that the scalar unit decides
};

// spread(column): what a column of the batch has for each ray, in four lanes each. Returns the lanes with a hit that
// may count.
template <class D, class Spread>
HWY_INLINE uint32_t testBlock(D d, const hal::TriangleBlock4 &block, const Batch &batch, Spread &&spread,
                              BlockHits &out) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d);
  const auto x = spread(batch.origin[batch.kx]), y = spread(batch.origin[batch.ky]);
  const auto z = spread(batch.origin[batch.kz]);
  const auto sx = spread(batch.sx), sy = spread(batch.sy);
  uint32_t found = 0;
  out.onEdge = 0;
  for (size_t i = 0; i < kBlockWidth; i += hn::Lanes(d)) {
    Corner<V> corners[3];
    for (int v = 0; v < 3; ++v) {
      const float(&vertex)[3][4] = block.vertices[v];
      const V depth = hn::Sub(hn::LoadDup128(d, vertex[batch.kz] + i), z);
      corners[v] = {hn::Sub(hn::Sub(hn::LoadDup128(d, vertex[batch.kx] + i), x), hn::Mul(sx, depth)),
                    hn::Sub(hn::Sub(hn::LoadDup128(d, vertex[batch.ky] + i), y), hn::Mul(sy, depth)), depth};
    }
    const auto &[a, b, c] = corners;
    const V wa = hn::Sub(hn::Mul(c.x, b.y), hn::Mul(c.y, b.x));
    const V wb = hn::Sub(hn::Mul(a.x, c.y), hn::Mul(a.y, c.x));
    const V wc = hn::Sub(hn::Mul(b.x, a.y), hn::Mul(b.y, a.x));
    const V least = hn::Min(hn::Min(wa, wb), wc), most = hn::Max(hn::Max(wa, wb), wc);
    const V side = sideOf(least, most);
    const auto onEdge = hn::Eq(side, zero), inside = hn::Gt(side, zero);
    const V scale = hn::Div(hn::Set(d, 1.0f), hn::Add(hn::Add(wa, wb), wc));
    const V height = hn::Add(hn::Add(hn::Mul(wa, a.z), hn::Mul(wb, b.z)), hn::Mul(wc, c.z));
    const V t = hn::Mul(hn::Mul(height, spread(batch.sz)), scale);
    const auto near = hn::And(hn::Gt(t, zero), hn::Le(t, spread(batch.t)));
    found |= bitsOf(d, hn::Or(onEdge, hn::And(inside, near))) << i;
    out.onEdge |= bitsOf(d, onEdge) << i;
    hn::Store(t, d, out.t + i);
    hn::Store(hn::Mul(wb, scale), d, out.u + i);
    hn::Store(hn::Mul(wc, scale), d, out.v + i);
  }
  return found;
}

// A lane with a hit that may count. Returns whether the ray has got a better hit, or is blocked.
template <bool kAny>
HWY_INLINE bool takeHit(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch, size_t ray,
                        const BlockHits &hits, size_t lane) {
  const uint32_t primitive = block.primitive[lane % kBlockWidth];
  if (primitive == hal::TriangleBlock4::kNone) return false;
  hal::Hit hit{hits.t[lane], hits.u[lane], hits.v[lane], 0};
  const bool onEdge = hits.onEdge >> lane & 1;
  if (onEdge && !hal::intersectTriangle(hal::ShearedRay(batch.ray(ray)), geometry.view.triangles[primitive], hit)) {
    return false;
  }
  hit.primitive = geometry.base + primitive;
  if constexpr (kAny) {
    return hit.t > batch.reach.begin && hit.t < batch.t[ray] && blockRay(geometry, batch, ray, primitive, hit);
  } else {
    if (!improves(batch, ray, hit)) return false;
    record(batch, ray, hit);
    return true;
  }
}

// Returns whether the ray has got a better hit, or is blocked.
template <bool kAny>
HWY_INLINE bool intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch, size_t ray) {
  const D4 d;
  BlockHits hits;
  uint32_t found = testBlock(
      d, block, batch, [&](const float *column) HWY_ATTR { return hn::Set(d, column[ray]); }, hits);
  bool changed = false;
  while (HWY_UNLIKELY(found)) {
    changed |= takeHit<kAny>(geometry, block, batch, ray, hits, nextBit(found));
    if (kAny && changed) break;
  }
  return changed;
}

#if HWY_MAX_BYTES >= 64
// Rays of a packet, four side by side.
class FewRays {
 public:
  static constexpr size_t kAtOnce = 4;

  HWY_INLINE FewRays(size_t packet, uint32_t lanes) : mPacket(packet * kPacketRays), mLast(hwy::PopCount(lanes) - 1) {
    const DU du;
    uint8_t bits[8] = {};
    std::memcpy(bits, &lanes, sizeof lanes);
    hn::Store(packed(du, countFrom(du, 0), hn::LoadMaskBits(du, bits)), du, mLanes);
  }
  HWY_INLINE size_t ray(size_t i) const { return mPacket + mLanes[i]; }

  // What a column of the batch has for the rays from `first` on, in four lanes each; the last one over the rest.
  HWY_INLINE auto spread(size_t first) const {
    const DU du;
    const auto which = hn::Add(hn::ShiftRight<2>(countFrom(du, 0)), hn::Set(du, static_cast<uint32_t>(first)));
    const auto there = hn::IndicesFromVec(du, hn::Min(which, hn::Set(du, mLast)));
    const auto places = hn::IndicesFromVec(D16(), hn::TableLookupLanes(hn::Load(du, mLanes), there));
    return [places, this](const float *column)
               HWY_ATTR { return hn::TableLookupLanes(hn::LoadU(D16(), column + mPacket), places); };
  }

 private:
  using DU = hn::RebindToUnsigned<D16>;

  size_t mPacket;
  uint32_t mLast;
  alignas(64) uint32_t mLanes[kPacketRays];
};
#endif

// The rays of a packet whose bits are set, some do. Returns whether one has got a better hit, or is blocked.
template <bool kAny>
HWY_INLINE bool intersectBlock(const Geometry &geometry, const hal::TriangleBlock4 &block, Batch &batch, size_t packet,
                               uint32_t lanes) {
  bool changed = false;
#if HWY_MAX_BYTES >= 64
  const FewRays rays(packet, lanes);
  const size_t count = hwy::PopCount(lanes);
  for (size_t first = 0; first < count; first += FewRays::kAtOnce) {
    BlockHits hits;
    uint32_t found = testBlock(D16(), block, batch, rays.spread(first), hits);
    if (count - first < FewRays::kAtOnce) found &= (1u << (count - first) * kBlockWidth) - 1;
    while (HWY_UNLIKELY(found)) {
      const uint32_t lane = nextBit(found);
      changed |= takeHit<kAny>(geometry, block, batch, rays.ray(first + lane / kBlockWidth), hits, lane);
    }
  }
#else
  while (lanes) changed |= intersectBlock<kAny>(geometry, block, batch, packet * kPacketRays + nextBit(lanes));
#endif
  return changed;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
