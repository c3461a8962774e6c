// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddi/cpu/units.h"

#include "rchal/units/shadow.h"
#include "rchal/units/shadow_ray.h"

namespace rc::ddi::cpu {

using namespace rc::hal;

namespace {

using Columns = std::array<const float *, 3>;

Columns columnsOf(const VectorsOfQueue &vectors) { return {vectors.x.data(), vectors.y.data(), vectors.z.data()}; }

void pad(VectorsOfQueue &vectors, size_t count) {
  for (FloatsOfQueue *column : {&vectors.x, &vectors.y, &vectors.z}) RayStream::pad(column->data(), count);
}

}  // namespace

void CpuUnits::closestHits(const SceneView &scene, RayQueue &rays, bool primary, HitQueue &hits) {
  for (VectorsOfQueue *vectors : {&rays.origin, &rays.direction}) pad(*vectors, rays.size());
  cpu::closestHits(scene,
                   {.origin = columnsOf(rays.origin),
                    .direction = columnsOf(rays.direction),
                    .count = rays.size(),
                    .common = primary && !scene.camera.parallel},
                   hits);
  if (primary) return;
  // The few that go on behind a hit ask the scalar unit.
  uint32_t after = kNoPrimitive;
  for (size_t i = 0; i < rays.size(); ++i) after &= rays.afterPrimitive[i];
  if (after == kNoPrimitive) return;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (rays.afterPrimitive[i] != kNoPrimitive) hits.set(i, nextHit(scene, rays.ray(i), rays.after(i), kInfinity));
  }
}

RayStream CpuUnits::streamOf(const SceneView &scene, size_t place, ShadowQueue &shadows) {
  const LightRow &light = scene.lights[place];
  const size_t count = shadows.size();
  pad(shadows.direction, count);
  RayStream::pad(shadows.from.data(), count);
  if (!light.sendsShadowRays) pad(shadows.origin, count);
  RayStream rays{.origin = columnsOf(shadows.origin),
                 .direction = columnsOf(shadows.direction),
                 .count = count,
                 .from = shadows.from.data(),
                 .common = light.sendsShadowRays,
                 .reach = reachOf(light)};
  if (!rays.common) return rays;
  mLights.resize(std::max(mLights.size(), scene.lights.size()));
  rays.origin = mLights[place].columns(light.position);
  return rays;
}

void CpuUnits::addVisible(const SceneView &scene, size_t light, ShadowQueue &shadows, const PixelSums &sums) {
  const size_t count = shadows.size();
  mBlocked.resize(count);
  const RayStream rays = streamOf(scene, light, shadows);
  if (!scene.filtersShadow()) {
    findBlocked(scene, rays, mBlocked.data(), nullptr);
    return addLit(shadows, mBlocked.data(), sums);
  }
  mFilters.reset(count);
  findBlocked(scene, rays, mBlocked.data(), &mFilters);
  // Rays that meet nothing are lit, those that meet filters alone follow.
  mFiltered.resize(0);
  for (uint32_t i = 0; i < count; ++i) {
    if (!mFilters.hasTooMany(i) && (mBlocked[i] || !mFilters.meetsAny(i))) continue;
    mBlocked[i] = 1;
    mFiltered.push_back(i);
  }
  addLit(shadows, mBlocked.data(), sums);
  for (size_t k = 0; k < mFiltered.size(); ++k) addFiltered(scene, scene.lights[light], shadows, mFiltered[k], sums);
}

void CpuUnits::addFiltered(const SceneView &scene, const LightRow &light, const ShadowQueue &shadows, uint32_t ray,
                           const PixelSums &sums) const {
  const Rgb colour = shadows.colour[ray];
  const Vec3 direction = shadows.direction[ray];
  const Reach reach = reachOf(light);
  if (mFilters.hasTooMany(ray)) {
    const Vec3 origin = light.sendsShadowRays ? light.position : shadows.origin[ray];
    return sums.add(shadows.pixel[ray], colour * visibility(scene, {origin, direction}, reach));
  }
  FilteredLight share(scene, reach.towardsLight(direction));
  mFilters.forEach(ray, [&](const Hit &hit) { return share.pass(hit); });
  sums.add(shadows.pixel[ray], colour * share.share());
}

}  // namespace rc::ddi::cpu
