// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// outline-inl.h: which triangles a packet may concern: their outlines as seen from where the rays meet, against its
// window of slopes, as a rasteriser tests tiles of pixels (Pineda: "A Parallel Algorithm for Polygon Rasterization",
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
  kWide = kEdges + 9,  // the edges' c for single rays
  kOutlineBounds = kWide + 3
};

struct alignas(64) Outlines {
  float bounds[kOutlineBounds][kLanes];
};

// A corner in slopes, relative to the middle of the beam's; its depth.
template <class V>
struct Seen {
  V x, y, z;
  V closeness;  // 1 / |z|
};

// What of three corners the outline is. All depths must have one sign. Returns where they do not, or where the numbers
// do not suffice: there everything overlaps.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> setOutline(D d, const Seen<V> (&seen)[3], V (&out)[kOutlineBounds]) {
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
  out[kCloseness] = hn::Max(hn::Max(a.closeness, b.closeness), c.closeness);
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
  return hn::Not(oneSide);
}

// Triangles on both sides of depth 0, such as walls beside a light, have no outline in slopes. But the planes through
// their edges and the point where rays meet bound what is seen of them: the half of the triangle's plane that lies
// before the rays tells which side of each is inside. (x, y, z): corners from that point, along the middle of the beam.
// side: the sign of the depths at which rays lie. reach: how far from that point, at most, rays go by it or beyond it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void setPlanes(D d, hn::Mask<D> where, const Corner<V> (&corners)[3], float side, float reach,
                          float rounding, V (&out)[kOutlineBounds]) {
  V size = hn::Zero(d);
  for (const auto &[x, y, z] : corners) size = hn::Max(size, hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Abs(z)));
  Corner<V> planes[3];
  for (size_t k = 0; k < 3; ++k) {
    const Corner<V> &from = corners[k], &to = corners[(k + 1) % 3];
    planes[k] = {hn::Sub(hn::Mul(from.y, to.z), hn::Mul(from.z, to.y)),
                 hn::Sub(hn::Mul(from.z, to.x), hn::Mul(from.x, to.z)),
                 hn::Sub(hn::Mul(from.x, to.y), hn::Mul(from.y, to.x))};
  }
  const auto &[p, q, r] = planes;
  const V volume = hn::MulAdd(p.x, corners[2].x, hn::MulAdd(p.y, corners[2].y, hn::Mul(p.z, corners[2].z)));
  const V normal = hn::Add(hn::Add(hn::Abs(hn::Add(hn::Add(p.x, q.x), r.x)), hn::Abs(hn::Add(hn::Add(p.y, q.y), r.y))),
                           hn::Abs(hn::Add(hn::Add(p.z, q.z), r.z)));
  const V error = hn::MulAdd(size, hn::Set(d, 0x1p-20f), hn::Set(d, rounding));  // of coordinates
  const V volumeError =
      hn::MulAdd(normal, hn::Set(d, reach), hn::Mul(hn::Mul(size, size), hn::Mul(error, hn::Set(d, 64.0f))));
  const V edgeError = hn::Mul(hn::Mul(size, hn::Set(d, 24.0f)), hn::Add(error, hn::Set(d, reach)));
  // Errors near nothing vanish.
  const auto numbers = hn::And(hn::Gt(volumeError, hn::Set(d, 1e-36f)), hn::Lt(edgeError, hn::Set(d, 1e30f)));
  const auto sure = hn::And(hn::And(where, numbers), hn::Gt(hn::Abs(volume), volumeError));
  const V sign = hn::CopySignToAbs(hn::Set(d, 1.0f), hn::Mul(volume, hn::Set(d, side)));
  for (size_t k = 0; k < 3; ++k) {
    V *edge = out + kEdges + 3 * k;
    edge[0] = hn::IfThenElse(sure, hn::Mul(planes[k].x, sign), edge[0]);
    edge[1] = hn::IfThenElse(sure, hn::Mul(planes[k].y, sign), edge[1]);
    edge[2] = hn::IfThenElse(sure, hn::MulAdd(planes[k].z, sign, edgeError), edge[2]);
  }
}

// The edges for single rays, which go by the point where they meet by `reach` at most.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void widenForRays(D d, float reach, V (&out)[kOutlineBounds]) {
  const V most = hn::Set(d, 1e30f);  // not infinite: edges that are nothing times that would be no number
  const V room = hn::Min(hn::MulAdd(out[kCloseness], hn::Set(d, reach), hn::Set(d, kSlopeMargin)), most);
  for (size_t k = 0; k < 3; ++k) {
    const V *edge = out + kEdges + 3 * k;
    out[kWide + k] = hn::MulAdd(hn::Add(hn::Abs(edge[0]), hn::Abs(edge[1])), room, edge[2]);
  }
}

HWY_INLINE void outline(const TriangleLanes &triangles, const Batch &batch, const Beam &beam, Outlines &out) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  using V = hn::Vec<D16>;
  const int axes[3] = {batch.kx, batch.ky, batch.kz};
  float origin[3] = {};
  for (size_t k = 0; k < 3 && batch.common; ++k) origin[k] = batch.origin[axes[k]][0];
  const V zSign = hn::Set(d, batch.zSign), zOffset = hn::Set(d, batch.zSign * origin[2] + beam.zOffset);
  const V xMeet = hn::Set(d, beam.xMeet - origin[0]), yMeet = hn::Set(d, beam.yMeet - origin[1]);
  for (size_t i = 0; i < kLanes; i += hn::Lanes(d)) {
    // From the point where rays meet.
    const auto cornerAt = [&](size_t v) HWY_ATTR {
      return Corner<V>{hn::Sub(hn::Load(d, triangles.corners[v][0] + i), xMeet),
                       hn::Sub(hn::Load(d, triangles.corners[v][1] + i), yMeet),
                       hn::MulAdd(hn::Load(d, triangles.corners[v][2] + i), zSign, zOffset)};
    };
    const V xSlope = hn::Set(d, beam.xSlope), ySlope = hn::Set(d, beam.ySlope);
    Seen<V> seen[3];
    for (size_t v = 0; v < 3; ++v) {
      const auto [x, y, z] = cornerAt(v);
      const V inverse = hn::Div(hn::Set(d, 1.0f), z);
      seen[v] = {hn::MulSub(x, inverse, xSlope), hn::MulSub(y, inverse, ySlope), z, hn::Abs(inverse)};
    }
    V bounds[kOutlineBounds];
    const auto none = hn::Eq(hn::Load(du, triangles.primitive + i), hn::Set(du, hal::TriangleBlock4::kNone));
    const auto open = hn::AndNot(hn::RebindMask(d, none), setOutline(d, seen, bounds));
    bounds[kFront] = hn::IfThenElse(hn::RebindMask(d, none), hn::Set(d, kInfinity), bounds[kFront]);
    if (!hn::AllFalse(d, open)) {
      Corner<V> corners[3];
      for (size_t v = 0; v < 3; ++v) {
        const auto [x, y, z] = cornerAt(v);
        corners[v] = {hn::NegMulAdd(xSlope, z, x), hn::NegMulAdd(ySlope, z, y), z};
      }
      setPlanes(d, open, corners, beam.side, beam.reach(), beam.rounding, bounds);
    }
    // Not a loop: compilers leave one of so many turns as it is, and all bounds in memory.
    const auto store = [&]<size_t... k>(std::index_sequence<k...>) HWY_ATTR {
      (hn::Store(bounds[k], d, out.bounds[k] + i), ...);
    };
    store(std::make_index_sequence<kWide>());
    if (!beam.asksRays) continue;
    widenForRays(d, beam.reach(), bounds);
    for (size_t k = kWide; k < kOutlineBounds; ++k) hn::Store(bounds[k], d, out.bounds[k] + i);
  }
}

// The rays of these slopes, relative to the middle of the beam's, that may meet the triangle. Slopes that are no
// numbers meet nothing.
HWY_INLINE hn::Mask<D16> mayMeet(const Outlines &outlines, size_t triangle, hn::Vec<D16> x, hn::Vec<D16> y) {
  const D16 d;
  const auto side = [&](size_t k) HWY_ATTR {
    const auto bound = [&](size_t i) HWY_ATTR { return hn::Set(d, outlines.bounds[i][triangle]); };
    return hn::MulAdd(bound(kEdges + 3 * k), x, hn::MulAdd(bound(kEdges + 3 * k + 1), y, bound(kWide + k)));
  };
  return hn::Ge(hn::Min(hn::Min(side(0), side(1)), side(2)), hn::Zero(d));
}

// Which of the triangles from i on have outlines that may have something in common with the window of a packet.
HWY_INLINE hn::Mask<D16> trianglesIn(const Outlines &outlines, const Beam &beam, size_t packet, size_t i) {
  const D16 d;
  using V = hn::Vec<D16>;
  const auto outline = [&](size_t bound) HWY_ATTR { return hn::Load(d, outlines.bounds[bound] + i); };
  const auto window = [&](WindowBound bound) HWY_ATTR { return hn::Set(d, beam.windows[bound][packet]); };
  const V closeness = outline(kCloseness), xMiddle = window(kXMiddle), yMiddle = window(kYMiddle);
  const V xHalf = hn::MulAdd(window(kXShift), closeness, window(kXHalf));
  const V yHalf = hn::MulAdd(window(kYShift), closeness, window(kYHalf));
  auto both = hn::And(hn::Le(outline(kFront), hn::Set(d, beam.bounds[kFar][packet])),
                      hn::Ge(outline(kBack), hn::Set(d, beam.bounds[kNear][packet])));
  both = hn::And(both, hn::Le(hn::Abs(hn::Sub(outline(kXCentre), xMiddle)), hn::Add(outline(kXReach), xHalf)));
  both = hn::And(both, hn::Le(hn::Abs(hn::Sub(outline(kYCentre), yMiddle)), hn::Add(outline(kYReach), yHalf)));
  for (size_t edge = kEdges; edge < kWide; edge += 3) {
    const V a = outline(edge), b = outline(edge + 1);
    const V middle = hn::MulAdd(a, xMiddle, hn::MulAdd(b, yMiddle, outline(edge + 2)));
    const V most = hn::MulAdd(hn::Abs(a), xHalf, hn::MulAdd(hn::Abs(b), yHalf, middle));
    both = hn::And(both, hn::Ge(most, hn::Zero(d)));
  }
  return both;
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
