// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// batch-inl.h: up to 512 rays whose directions have the same largest component, with the same sign, as columns
// in the axes of the watertight test: z is that component's axis. (units/intersection.h, ShearedRay)
#if defined(RAYCORE_KERNELS_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_BATCH_INL
#undef RAYCORE_KERNELS_BATCH_INL
#else
#define RAYCORE_KERNELS_BATCH_INL
#endif

#include "rcddi/cpu/kernels/vectors-inl.h"
#include "rcddi/cpu/trace.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

constexpr size_t kPacketRays = RayStream::kPacket;
constexpr size_t kPackets = 32;
constexpr size_t kBatchRays = kPacketRays * kPackets;
static_assert(kBatchRays == RayStream::kGroup);
constexpr size_t kRoom = kBatchRays + kPacketRays;  // a vector may be written behind the last ray
constexpr size_t kClasses = 6;                      // largest component, twice, plus 1 if negative

struct alignas(64) Batch {
  size_t rays, packets;
  int kx, ky, kz;
  bool inPlace;                           // the batch is a whole group
  bool numbers;                           // there is no NaN: it would spoil the bounds of other rays
  bool common;                            // all rays have one origin
  float zSign;                            // of the directions
  float size;                             // the largest absolute coordinate of origins: what rounding errors grow with
  float slowest, fastest;                 // of the directions, along z
  float start, end;                       // where the first ray starts and the last one ends, along zSign * z
  const float *origin[3], *direction[3];  // in world axes
  const uint32_t *from;                   // see RayStream; may be null
  size_t first;                           // of the group in the stream
  hal::Reach reach;                       // of rays that ask what blocks them
  FilterHits *filters;                    // where these cross filters; may be null
  alignas(64) float sx[kBatchRays], sy[kBatchRays], sz[kBatchRays];
  float t[kBatchRays];  // of the best hit, or how far to look; -infinity: needs no more
  float u[kBatchRays], v[kBatchRays];
  uint32_t primitive[kBatchRays];
  // If the batch is not in place: which rays of the group it has, and what origin, direction and from point to.
  uint32_t index[kRoom];
  float columns[6][kRoom];
  uint32_t fromColumn[kRoom];

  hal::Ray ray(size_t i) const {
    return {{origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}};
  }
  size_t place(size_t i) const { return first + (inPlace ? i : index[i]); }  // in the stream
};

// The class of all rays; -1 if they have none in common, or if that is not easily seen.
HWY_INLINE int commonClass(const RayStream &rays, size_t first, size_t count) {
  const D16 d;
  const int axis = hal::mainAxis({rays.direction[0][first], rays.direction[1][first], rays.direction[2][first]});
  const float *along = rays.direction[axis] + first, *other = rays.direction[(axis + 1) % 3] + first;
  const float *third = rays.direction[(axis + 2) % 3] + first;
  const bool negative = along[0] < 0;
  const auto sign = hn::Set(d, negative ? -1.0f : 1.0f);
  auto least = hn::Set(d, kInfinity);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto rest = hn::Max(hn::Abs(hn::LoadU(d, other + i)), hn::Abs(hn::LoadU(d, third + i)));
    least = hn::Min(least, hn::MulSub(sign, hn::LoadU(d, along + i), rest));
  }
  return hn::AllTrue(d, hn::Gt(least, hn::Zero(d))) ? 2 * axis + negative : -1;
}

// The class of each ray, with the same comparisons as ShearedRay; -1 behind the last one.
HWY_INLINE void classify(const RayStream &rays, size_t first, size_t count, int32_t *classes) {
  const D16 d;
  const hn::RebindToSigned<D16> di;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, rays.direction[0] + first + i), y = hn::LoadU(d, rays.direction[1] + first + i);
    const auto z = hn::LoadU(d, rays.direction[2] + first + i);
    const auto ax = hn::Abs(x), ay = hn::Abs(y), az = hn::Abs(z);
    const auto xBeatsY = hn::Gt(ax, ay);
    const auto isX = hn::And(xBeatsY, hn::Gt(ax, az)), isY = hn::AndNot(xBeatsY, hn::Gt(ay, az));
    const auto largest = hn::IfThenElse(isX, x, hn::IfThenElse(isY, y, z));
    const auto axis = hn::IfThenElse(hn::RebindMask(di, isX), hn::Zero(di),
                                     hn::IfThenElse(hn::RebindMask(di, isY), hn::Set(di, 2), hn::Set(di, 4)));
    const auto negative =
        hn::IfThenElse(hn::RebindMask(di, hn::Lt(largest, hn::Zero(d))), hn::Set(di, 1), hn::Zero(di));
    const auto there = lanesUpTo(di, i, count);
    hn::StoreU(hn::IfThenElse(there, hn::Or(axis, negative), hn::Set(di, -1)), di, classes + i);
  }
}

// kOne: the rays are known to have one origin. A sum is no number if one of its parts is none.
template <bool kAny, bool kOne>
HWY_INLINE void setUpColumns(Batch &batch) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  using V = hn::Vec<D16>;
  const float *ox = batch.origin[batch.kx], *oy = batch.origin[batch.ky], *oz = batch.origin[batch.kz];
  const V x0 = hn::Set(d, ox[0]), y0 = hn::Set(d, oy[0]), z0 = hn::Set(d, oz[0]), sign = hn::Set(d, batch.zSign);
  const V one = hn::Add(x0, hn::Add(y0, z0)), oneDepth = hn::Mul(z0, sign),
          t = hn::Set(d, kAny ? batch.reach.end : kInfinity);
  auto same = hn::Eq(sign, sign), numbers = hn::Eq(one, one);
  V size = hn::Max(hn::Abs(x0), hn::Max(hn::Abs(y0), hn::Abs(z0)));
  V fastest = hn::Zero(d), slowest = hn::Set(d, kInfinity), start = oneDepth, end = hn::Neg(slowest);
  for (size_t i = 0; i < batch.packets * kPacketRays; i += hn::Lanes(d)) {
    V depth = oneDepth;
    if constexpr (!kOne) {
      const V x = hn::LoadU(d, ox + i), y = hn::LoadU(d, oy + i), z = hn::LoadU(d, oz + i);
      same = hn::And(same, hn::And(hn::Eq(x, x0), hn::And(hn::Eq(y, y0), hn::Eq(z, z0))));
      size = hn::Max(size, hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z))));
      const V all = hn::Add(x, hn::Add(y, z));
      numbers = hn::And(numbers, hn::Eq(all, all));
      depth = hn::Mul(z, sign);
      start = hn::Min(start, depth);
    }
    const V direction = hn::LoadU(d, batch.direction[batch.kz] + i), speed = hn::Abs(direction);
    slowest = hn::Min(slowest, speed);
    fastest = hn::Max(fastest, speed);
    const V sz = hn::Div(hn::Set(d, 1.0f), direction);
    const V sx = hn::Mul(hn::LoadU(d, batch.direction[batch.kx] + i), sz);
    const V sy = hn::Mul(hn::LoadU(d, batch.direction[batch.ky] + i), sz);
    hn::Store(sx, d, batch.sx + i);
    hn::Store(sy, d, batch.sy + i);
    hn::Store(sz, d, batch.sz + i);
    hn::Store(t, d, batch.t + i);
    const V slopes = hn::Add(sx, sy);
    numbers = hn::And(numbers, hn::Eq(slopes, slopes));
    end = hn::Max(end, hn::MulAdd(t, speed, depth));
    if constexpr (!kAny) {
      hn::Store(hn::Zero(d), d, batch.u + i);
      hn::Store(hn::Zero(d), d, batch.v + i);
      hn::Store(hn::Set(du, hal::kNoPrimitive), du, batch.primitive + i);
    }
  }
  batch.numbers = hn::AllTrue(d, numbers);
  batch.common = hn::AllTrue(d, same);
  batch.size = hn::GetLane(hn::MaxOfLanes(d, size));
  batch.slowest = hn::GetLane(hn::MinOfLanes(d, slowest));
  batch.fastest = hn::GetLane(hn::MaxOfLanes(d, fastest));
  batch.start = hn::GetLane(hn::MinOfLanes(d, start));
  batch.end = hn::GetLane(hn::MaxOfLanes(d, end));
}

// Everything but the pointers to the columns and index.
template <bool kAny>
HWY_INLINE void setUp(Batch &batch, const RayStream &stream, size_t rays, int rayClass) {
  batch.rays = rays;
  batch.packets = (rays + kPacketRays - 1) / kPacketRays;
  batch.kz = rayClass / 2;
  batch.kx = (batch.kz + 1) % 3;
  batch.ky = (batch.kx + 1) % 3;
  if (rayClass & 1) std::swap(batch.kx, batch.ky);  // keeps the winding
  batch.zSign = rayClass & 1 ? -1.0f : 1.0f;
  if (stream.common) {
    setUpColumns<kAny, true>(batch);
  } else {
    setUpColumns<kAny, false>(batch);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
