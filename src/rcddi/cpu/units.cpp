// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddi/cpu/units.h"

#include "rcddi/cpu/trace.h"
#include "rchal/units/shadow.h"

namespace rc::ddi::cpu {

using namespace rc::hal;

namespace {

RayStream streamOf(const Vec3Column &origin, const Vec3Column &direction, size_t count) {
  return {{origin.x.data(), origin.y.data(), origin.z.data()},
          {direction.x.data(), direction.y.data(), direction.z.data()},
          count};
}

}  // namespace

void CpuUnits::closestHits(const SceneView &scene, const RayQueue &rays, HitQueue &hits) {
  cpu::closestHits(scene, streamOf(rays.origin, rays.direction, rays.size()), hits.data());
  // The few that go on behind a hit ask the scalar unit.
  uint32_t after = kNoPrimitive;
  for (size_t i = 0; i < rays.size(); ++i) after &= rays.afterPrimitive[i];
  if (after == kNoPrimitive) return;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (rays.afterPrimitive[i] != kNoPrimitive) hits[i] = nextHit(scene, rays.ray(i), rays.after(i), kInfinity);
  }
}

void CpuUnits::addVisible(const SceneView &scene, const ShadowQueue &shadows, const PixelSums &sums) {
  const size_t count = shadows.size();
  mEnd.resize(count);
  mBlocked.resize(count);
  for (size_t i = 0; i < count; ++i) mEnd[i] = shadowEnd(shadows.distance[i]);
  const RayStream rays = streamOf(shadows.origin, shadows.direction, count);
  findBlocked(scene, rays, mEnd.data(), Blocking::Opaque, mBlocked.data());
  if (!scene.filtersShadow()) return addLit(shadows, mBlocked.data(), sums);
  // Rays that meet nothing are lit, those that meet filters alone ask the scalar unit.
  mFiltered.resize(count);
  for (size_t i = 0; i < count; ++i) mEnd[i] = mBlocked[i] ? -kInfinity : mEnd[i];
  findBlocked(scene, rays, mEnd.data(), Blocking::Filter, mFiltered.data());
  for (size_t i = 0; i < count; ++i) {
    mFiltered[i] &= !mBlocked[i];
    mBlocked[i] |= mFiltered[i];
  }
  addLit(shadows, mBlocked.data(), sums);
  for (size_t i = 0; i < count; ++i) {
    if (!mFiltered[i]) continue;
    const ShadowItem item = shadows[i];
    sums.add(item.pixel, item.colour * throughFilters(scene, item.ray, mEnd[i]));
  }
}

}  // namespace rc::ddi::cpu
