// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// group-inl.h: 512 rays of a stream: sorted into classes of direction, each class by beams of all its packets, of one
// packet, or ray by ray: whichever the spread of its rays allows. Through a KD-tree, packets.
#if defined(RAYCORE_KERNELS_GROUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_KERNELS_GROUP_INL
#undef RAYCORE_KERNELS_GROUP_INL
#else
#define RAYCORE_KERNELS_GROUP_INL
#endif

#include "rcddi/cpu/kernels/beam_setup-inl.h"
#include "rcddi/cpu/kernels/beam_walk-inl.h"
#include "rcddi/cpu/kernels/kd_walk-inl.h"
#include "rcddi/cpu/kernels/lanes_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// So few packets have too little in common to pay for a beam.
constexpr size_t kFewPackets = 2;

// How wide a packet may get: with more triangles than that side by side, its rays go alone. Measured with bench/trace;
// half and double that make little difference.
constexpr float kMostGrains = 6;

// With more triangles than this side by side, rays are asked one by one which of them they may meet; those that look
// for what blocks them, always.
constexpr float kFineGrains = 2;

inline float widest(const hal::AccelView &accel) {
  return std::min(0.25f * glm::length(accel.core.size()), kMostGrains * accel.grain);
}

template <bool kAny>
HWY_INLINE bool walkPackets(const Geometry &geometry, Batch &batch, Beam &beam) {
  return batch.common ? walkWithBeam<kAny, true>(geometry, batch, beam)
                      : walkWithBeam<kAny, false>(geometry, batch, beam);
}

// What blocks a ray, and which filters it crosses.
inline void blockWithUnit(const hal::SceneView &scene, const Geometry &geometry, Batch &batch, size_t i) {
  const hal::Ray ray = batch.ray(i);
  hal::Reach reach = batch.reach;
  reach.end = batch.t[i];
  if (hal::isBlocked(scene, ray, reach)) reach.end = batch.t[i] = -kInfinity;
  if (!geometry.view.filtersShadow) return;
  hal::forEachHit(scene, ray, reach, [&](hal::Hit hit) {
    const uint32_t primitive = hit.primitive;
    hit.primitive += geometry.base;
    return !blockRay(geometry, batch, i, primitive, hit);
  });
}

// The scalar unit, for rays from beyond what the kernels' margins cover.
template <bool kAny>
HWY_NOINLINE void traceWithUnit(const Geometry &geometry, Batch &batch) {
  hal::SceneView scene;
  scene.geometry[0] = geometry.view;
  for (size_t i = 0; i < batch.rays; ++i) {
    if (kAny) {
      blockWithUnit(scene, geometry, batch, i);
      continue;
    }
    hal::Hit hit = hal::closestHit(scene, batch.ray(i));
    if (!hit.found()) continue;
    hit.primitive += geometry.base;
    if (improves(batch, i, hit)) record(batch, i, hit);
  }
}

// Whether all numbers are so far from the limits of floats that no product of two overflows or vanishes.
inline bool isTame(const Batch &batch, float extent) {
  constexpr float kLarge = 1e12f;
  return batch.numbers && batch.fastest < kLarge && batch.slowest > 1 / kLarge && extent < kLarge &&
         batch.size < kLarge;
}

template <bool kAny>
HWY_INLINE void walkKdTree(const Geometry &geometry, Batch &batch) {
  for (size_t packet = 0; packet < batch.packets; ++packet) {
    if (batch.common) {
      walkKdTree<kAny, true>(geometry, batch, packet);
    } else {
      walkKdTree<kAny, false>(geometry, batch, packet);
    }
  }
}

template <bool kAny>
HWY_INLINE void traceBatch(const Geometry &geometry, Batch &batch) {
  const Bounds &bounds = geometry.view.accel.bounds;
  const float extent = maxComponent(glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper)));
  const AccelKind kind = geometry.view.accel.kind;
  if (kind == AccelKind::Exhaustive || !isTame(batch, extent)) return traceWithUnit<kAny>(geometry, batch);
  if (kind == AccelKind::KdTree) return walkKdTree<kAny>(geometry, batch);
  const bool endless = !kAny && geometry.base == 0;  // rays end where they hit another geometry
  Beam beam;
  beam.packets = 0;
  if (batch.packets > kFewPackets) {
    const hal::AccelView &accel = geometry.view.accel;
    makeBeam(batch, accel, widest(accel), kAny ? -1 : kFineGrains * accel.grain, endless, beam);
  }
  if (beam.packets && !walkPackets<kAny>(geometry, batch, beam)) beam.packets = 0;
  for (size_t packet = 0; packet < batch.packets; ++packet) {
    if (!(beam.packets >> packet & 1)) walkInLanes<kAny>(geometry, batch, packet);
  }
}

// Hits in the order of the stream.
HWY_INLINE void deliverInPlace(const Batch &batch, hal::HitQueue &hits) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  for (size_t i = 0; i < batch.rays; i += hn::Lanes(d)) {
    const size_t to = batch.first + i;
    hn::StoreU(hn::Load(d, batch.t + i), d, hits.t.data() + to);
    hn::StoreU(hn::Load(d, batch.u + i), d, hits.u.data() + to);
    hn::StoreU(hn::Load(d, batch.v + i), d, hits.v.data() + to);
    hn::StoreU(hn::Load(du, batch.primitive + i), du, hits.primitive.data() + to);
  }
}

HWY_INLINE void deliverInPlace(const Batch &batch, uint8_t *HWY_RESTRICT blocked) {
  const float *HWY_RESTRICT t = batch.t;
  for (size_t i = 0; i < batch.rays; ++i) blocked[i] = t[i] == -kInfinity;
}

template <bool kAny>
HWY_INLINE void deliver(const Batch &batch, hal::HitQueue *hits, uint8_t *blocked) {
  if constexpr (kAny) {
    if (batch.inPlace) return deliverInPlace(batch, blocked + batch.first);
    for (size_t i = 0; i < batch.rays; ++i) blocked[batch.place(i)] = batch.t[i] == -kInfinity;
  } else {
    if (batch.inPlace) return deliverInPlace(batch, *hits);
    for (size_t i = 0; i < batch.rays; ++i) {
      hits->set(batch.place(i), {batch.t[i], batch.u[i], batch.v[i], batch.primitive[i]});
    }
  }
}

template <bool kAny>
HWY_INLINE void traceClass(const hal::SceneView &scene, Batch &batch, hal::HitQueue *hits, uint8_t *blocked) {
  uint32_t base = 0;
  for (const hal::GeometryView &geometry : scene.geometry) {
    if (!geometry.triangles.empty()) traceBatch<kAny>({geometry, base}, batch);
    base += static_cast<uint32_t>(geometry.triangles.size());
  }
  deliver<kAny>(batch, hits, blocked);
}

// Packs the lanes of a mask behind the n values that a column of a batch has.
HWY_INLINE void pack(const float *from, hn::Mask<D16> lanes, size_t n, float *column) {
  const D16 d;
  hn::StoreU(packed(d, hn::LoadU(d, from), lanes), d, column + n);
}

// Copies the rays of a class into the batch's own columns, and the last one over the rest of its packet. Returns how
// many.
HWY_INLINE size_t gather(const RayStream &rays, const int32_t *classes, size_t count, int rayClass, Batch &batch) {
  const D16 d;
  const hn::RebindToSigned<D16> di;
  const hn::RebindToUnsigned<D16> du;
  size_t n = 0;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto lanes = hn::RebindMask(d, hn::Eq(hn::LoadU(di, classes + i), hn::Set(di, rayClass)));
    if (hn::AllFalse(d, lanes)) continue;
    const size_t from = batch.first + i;
    for (int axis = 0; axis < 3; ++axis) {
      if (!rays.common) pack(rays.origin[axis] + from, lanes, n, batch.columns[axis]);
      pack(rays.direction[axis] + from, lanes, n, batch.columns[3 + axis]);
    }
    const auto index = countFrom(du, i);
    hn::StoreU(packed(du, index, hn::RebindMask(du, lanes)), du, batch.index + n);
    if (rays.from) {
      hn::StoreU(packed(du, hn::LoadU(du, rays.from + from), hn::RebindMask(du, lanes)), du, batch.fromColumn + n);
    }
    n += hn::CountTrue(d, lanes);
  }
  const size_t rest = n % kPacketRays ? kPacketRays - n % kPacketRays : 0;
  for (size_t k = rays.common ? 3 : 0; k < 6 && rest; ++k) {
    std::fill_n(batch.columns[k] + n, rest, batch.columns[k][n - 1]);
  }
  if (rays.from && rest) std::fill_n(batch.fromColumn + n, rest, batch.fromColumn[n - 1]);
  batch.from = rays.from ? batch.fromColumn : nullptr;
  for (int axis = 0; axis < 3; ++axis) {
    batch.origin[axis] = rays.common ? rays.origin[axis] : batch.columns[axis];
    batch.direction[axis] = batch.columns[3 + axis];
  }
  return n;
}

template <bool kAny>
HWY_INLINE void traceGroup(const hal::SceneView &scene, const RayStream &rays, size_t first, size_t count,
                           FilterHits *filters, hal::HitQueue *hits, uint8_t *blocked) {
  Batch batch;
  batch.first = first;
  batch.reach = rays.reach;
  batch.filters = filters;
  const int common = commonClass(rays, first, count);
  batch.inPlace = common >= 0;
  if (batch.inPlace) {
    for (int axis = 0; axis < 3; ++axis) {
      batch.origin[axis] = rays.origin[axis] + (rays.common ? 0 : first);
      batch.direction[axis] = rays.direction[axis] + first;
    }
    batch.from = rays.from ? rays.from + first : nullptr;
    setUp<kAny>(batch, rays, count, common);
    return traceClass<kAny>(scene, batch, hits, blocked);
  }
  alignas(64) int32_t classes[kBatchRays];
  classify(rays, first, count, classes);
  for (int rayClass = 0; rayClass < int(kClasses); ++rayClass) {
    const size_t n = gather(rays, classes, count, rayClass, batch);
    if (n == 0) continue;
    setUp<kAny>(batch, rays, n, rayClass);
    traceClass<kAny>(scene, batch, hits, blocked);
  }
}

// filters: of rays that ask kAny; may be null.
template <bool kAny>
inline void traceStream(const hal::SceneView &scene, const RayStream &rays, FilterHits *filters, hal::HitQueue *hits,
                        uint8_t *blocked) {
  for (size_t first = 0; first < rays.count; first += kBatchRays) {
    traceGroup<kAny>(scene, rays, first, std::min(kBatchRays, rays.count - first), filters, hits, blocked);
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
