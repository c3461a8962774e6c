// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// outline-inl.h: which packets a triangle may concern: its outline as seen from where the rays meet, against their
// windows of slopes, as a rasteriser tests tiles of pixels (Pineda: "A Parallel Algorithm for Polygon Rasterization",
// SIGGRAPH 1988). It only sorts out: margins cover all rounding, and packet-inl.h decides about hits.
#if defined(RAYCORE_KERNELS_OUTLINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_OUTLINE_INL
#undef RAYCORE_KERNELS_OUTLINE_INL
#else
#define RAYCORE_KERNELS_OUTLINE_INL
#endif

#include "rcddi/cpu/kernels/beam-inl.h"
#include "rcddi/cpu/kernels/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Rectangle around a triangle in slopes, depths, and three edges: inside, a x + b y + c >= 0.
enum OutlineBound {
  kXCentre,
  kXReach,
  kYCentre,
  kYReach,
  kCloseness,  // 1 / smallest |depth|
  kFront,
  kBack,
  kEdges,
  kOutlineBounds = kEdges + 9
};

struct alignas(16) BlockOutlines {
  Corners corners;  // as intersectPacket() wants them
  float bounds[kOutlineBounds][hal::TriangleBlock4::kWidth];
};

// Lanes where the outline and the window may have something in common.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> overlap(D d, const V (&outline)[kOutlineBounds], const V (&window)[kWindowBounds]) {
  const V xHalf = hn::MulAdd(window[kXShift], outline[kCloseness], window[kXHalf]);
  const V yHalf = hn::MulAdd(window[kYShift], outline[kCloseness], window[kYHalf]);
  auto both = hn::And(hn::Le(outline[kFront], window[kLast]), hn::Ge(outline[kBack], window[kFirst]));
  both = hn::And(both, hn::Le(hn::Abs(hn::Sub(outline[kXCentre], window[kXMiddle])), hn::Add(outline[kXReach], xHalf)));
  both = hn::And(both, hn::Le(hn::Abs(hn::Sub(outline[kYCentre], window[kYMiddle])), hn::Add(outline[kYReach], yHalf)));
  for (size_t edge = kEdges; edge < kOutlineBounds; edge += 3) {
    const V a = outline[edge], b = outline[edge + 1];
    const V middle = hn::MulAdd(a, window[kXMiddle], hn::MulAdd(b, window[kYMiddle], outline[edge + 2]));
    const V most = hn::MulAdd(hn::Abs(a), xHalf, hn::MulAdd(hn::Abs(b), yHalf, middle));
    both = hn::And(both, hn::Ge(most, hn::Zero(d)));
  }
  return both;
}

// A corner in slopes, relative to the middle of the beam's.
template <class V>
struct Seen {
  V x, y, z;
};

// What of three corners the outline is. All depths must have one sign; where they do not, everything overlaps.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void setOutline(D d, const Seen<V> (&seen)[3], V (&out)[kOutlineBounds]) {
  const auto &[a, b, c] = seen;
  const V front = hn::Min(hn::Min(a.z, b.z), c.z), back = hn::Max(hn::Max(a.z, b.z), c.z);
  const V closest = hn::Max(front, hn::Neg(back));
  const V xLeast = hn::Min(hn::Min(a.x, b.x), c.x), xMost = hn::Max(hn::Max(a.x, b.x), c.x);
  const V yLeast = hn::Min(hn::Min(a.y, b.y), c.y), yMost = hn::Max(hn::Max(a.y, b.y), c.y);
  // Slopes are off by about their own rounding; relative to the middle of the beam they may be much smaller than it.
  const V xSize = hn::Max(hn::Abs(xLeast), hn::Abs(xMost)), ySize = hn::Max(hn::Abs(yLeast), hn::Abs(yMost));
  const V error = hn::Mul(hn::Add(hn::Max(xSize, ySize), hn::Set(d, 2.0f)), hn::Set(d, 0x1p-20f));
  const V half = hn::Set(d, 0.5f);
  out[kXCentre] = hn::Mul(hn::Add(xLeast, xMost), half);
  out[kYCentre] = hn::Mul(hn::Add(yLeast, yMost), half);
  const V xExtent = hn::Sub(xMost, xLeast), yExtent = hn::Sub(yMost, yLeast);
  out[kXReach] = hn::MulAdd(xExtent, half, error);
  out[kYReach] = hn::MulAdd(yExtent, half, error);
  out[kCloseness] = hn::Div(hn::Set(d, 1.0f), closest);
  const V depthMargin = hn::Mul(hn::Max(hn::Abs(front), hn::Abs(back)), hn::Set(d, 0x1p-19f));
  out[kFront] = hn::Sub(front, depthMargin);
  out[kBack] = hn::Add(back, depthMargin);
  const V area = hn::Sub(hn::Mul(hn::Sub(b.x, a.x), hn::Sub(c.y, a.y)), hn::Mul(hn::Sub(c.x, a.x), hn::Sub(b.y, a.y)));
  const V edgeError = hn::Mul(error, hn::Mul(hn::Set(d, 8.0f), hn::Add(hn::Add(xExtent, yExtent), error)));
  for (size_t k = 0; k < 3; ++k) {
    const Seen<V> &from = seen[k], &to = seen[(k + 1) % 3];
    const V x = hn::CopySignToAbs(hn::Set(d, 1.0f), area);
    const V right = hn::Mul(hn::Sub(from.y, to.y), x), up = hn::Mul(hn::Sub(to.x, from.x), x);
    out[kEdges + 3 * k] = right;
    out[kEdges + 3 * k + 1] = up;
    out[kEdges + 3 * k + 2] = hn::NegMulAdd(right, from.x, hn::NegMulAdd(up, from.y, edgeError));
  }
  // NaN counts as on both sides.
  const auto oneSide = hn::And(hn::Gt(closest, hn::Set(d, 1e-30f)), hn::Lt(edgeError, hn::Set(d, 1e30f)));
  for (const size_t k : {size_t(kXReach), size_t(kYReach), kEdges + 2ul, kEdges + 5ul, kEdges + 8ul}) {
    out[k] = hn::IfThenElse(oneSide, out[k], hn::Set(d, kInfinity));
  }
  for (const size_t k : {size_t(kXCentre), size_t(kYCentre), size_t(kCloseness), kEdges + 0ul, kEdges + 1ul,
                         kEdges + 3ul, kEdges + 4ul, kEdges + 6ul, kEdges + 7ul}) {
    out[k] = hn::IfThenElseZero(oneSide, out[k]);
  }
}

// Returns the triangles that the beam may meet.
HWY_INLINE uint32_t outline(const hal::TriangleBlock4 &block, const Batch &batch, const Beam &beam,
                            BlockOutlines &out) {
  const D4 d;
  using V = hn::Vec<D4>;
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  V window[kWindowBounds];
  for (size_t k = 0; k < kWindowBounds; ++k) window[k] = hn::Set(d, beam.window[k]);
  uint32_t met = 0;
  for (size_t i = 0; i < hal::TriangleBlock4::kWidth; i += hn::Lanes(d)) {
    Seen<V> seen[3];
    for (size_t v = 0; v < 3; ++v) {
      V world[3];
      for (size_t k = 0; k < 3; ++k) {
        world[k] = hn::Load(d, block.vertices[v][axes[k]] + i);
        const V origin = hn::Set(d, batch.common ? batch.origin[axes[k]][0] : 0.0f);
        hn::Store(hn::Sub(world[k], origin), d, out.corners[v][k] + i);
      }
      const V z = hn::MulAdd(world[2], hn::Set(d, beam.zSign), hn::Set(d, beam.zOffset));
      const V inverse = hn::Div(hn::Set(d, 1.0f), z);
      seen[v].x = hn::MulSub(hn::Sub(world[0], hn::Set(d, beam.xMeet)), inverse, hn::Set(d, beam.xSlope));
      seen[v].y = hn::MulSub(hn::Sub(world[1], hn::Set(d, beam.yMeet)), inverse, hn::Set(d, beam.ySlope));
      seen[v].z = z;
    }
    V bounds[kOutlineBounds];
    setOutline(d, seen, bounds);
    met |= bitsOf(d, overlap(d, bounds, window)) << i;
    for (size_t k = 0; k < kOutlineBounds; ++k) hn::Store(bounds[k], d, out.bounds[k] + i);
  }
  return met;
}

// Packets whose windows may have something in common with a triangle of the block.
HWY_INLINE uint32_t packetsThatMeet(const BlockOutlines &block, size_t triangle, const Beam &beam) {
  const D16 d;
  using V = hn::Vec<D16>;
  V outline[kOutlineBounds];
  for (size_t k = 0; k < kOutlineBounds; ++k) outline[k] = hn::Set(d, block.bounds[k][triangle]);
  uint32_t bits = 0;
  for (size_t p = 0; p < kPackets; p += hn::Lanes(d)) {
    V window[kWindowBounds];
    for (size_t k = 0; k < kWindowBounds; ++k) window[k] = hn::Load(d, beam.windows[k] + p);
    bits |= bitsOf(d, overlap(d, outline, window)) << p;
  }
  return bits;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
