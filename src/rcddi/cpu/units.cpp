// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddi/cpu/units.h"

#include "rcddi/cpu/trace.h"
#include "rchal/units/shadow.h"

namespace rc::ddi::cpu {

using namespace rc::hal;

namespace {

RayStream streamOf(const VectorsOfQueue &origin, const VectorsOfQueue &direction, size_t count) {
  return {{origin.x.data(), origin.y.data(), origin.z.data()},
          {direction.x.data(), direction.y.data(), direction.z.data()},
          count};
}

}  // namespace

void CpuUnits::closestHits(const SceneView &scene, const RayQueue &rays, HitQueue &hits) {
  cpu::closestHits(scene, streamOf(rays.origin, rays.direction, rays.size()), hits);
  // The few that go on behind a hit ask the scalar unit.
  uint32_t after = kNoPrimitive;
  for (size_t i = 0; i < rays.size(); ++i) after &= rays.afterPrimitive[i];
  if (after == kNoPrimitive) return;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (rays.afterPrimitive[i] != kNoPrimitive) hits.set(i, nextHit(scene, rays.ray(i), rays.after(i), kInfinity));
  }
}

void CpuUnits::addVisible(const SceneView &scene, const ShadowQueue &shadows, const PixelSums &sums) {
  const size_t count = shadows.size();
  mEnd.resize(count);
  mBlocked.resize(count);
  for (size_t i = 0; i < count; ++i) mEnd[i] = shadowEnd(shadows.distance[i]);
  RayStream rays = streamOf(shadows.origin, shadows.direction, count);
  rays.from = shadows.from.data();
  if (!scene.filtersShadow()) {
    findBlocked(scene, rays, mEnd.data(), mBlocked.data(), nullptr);
    return addLit(shadows, mBlocked.data(), sums);
  }
  mFilters.reset(count);
  findBlocked(scene, rays, mEnd.data(), mBlocked.data(), &mFilters);
  // Rays that meet nothing are lit, those that meet filters alone follow.
  mFiltered.resize(0);
  for (uint32_t i = 0; i < count; ++i) {
    if (!mFilters.hasTooMany(i) && (mBlocked[i] || !mFilters.meetsAny(i))) continue;
    mBlocked[i] = 1;
    mFiltered.push_back(i);
  }
  addLit(shadows, mBlocked.data(), sums);
  for (size_t k = 0; k < mFiltered.size(); ++k) addFiltered(scene, shadows[mFiltered[k]], mFiltered[k], sums);
}

void CpuUnits::addFiltered(const SceneView &scene, const ShadowItem &item, size_t ray, const PixelSums &sums) const {
  if (mFilters.hasTooMany(ray)) {
    return sums.add(item.pixel, item.colour * visibility(scene, item.ray, item.distance));
  }
  FilteredLight light(scene, item.ray.direction);
  mFilters.forEach(ray, [&](const Hit &hit) { return light.pass(hit); });
  sums.add(item.pixel, item.colour * light.share());
}

}  // namespace rc::ddi::cpu
