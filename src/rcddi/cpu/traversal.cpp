// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddi/cpu/traversal.h"

#include "rchal/units/shadow.h"

namespace rc::ddi::cpu {

using namespace rc::hal;

void CpuTraversal::closestHits(const SceneView &scene, const RayQueue &rays, HitQueue &hits) const {
  hits.resize(rays.size());
  cpu::closestHits(scene,
                   {{rays.origin.x.data(), rays.origin.y.data(), rays.origin.z.data()},
                    {rays.direction.x.data(), rays.direction.y.data(), rays.direction.z.data()},
                    hits.size()},
                   hits.data());
  // The few that go on behind a hit ask the scalar unit.
  for (size_t i = 0; i < rays.size(); ++i) {
    if (rays.after[i].primitive != kNoPrimitive) hits[i] = nextHit(scene, rays.ray(i), rays.after[i], kInfinity);
  }
}

// A pixel's rays to several lights follow each other in the queue. All first ones, then all second ones and so on:
// rays to one light, which have its place in common, lie beside each other.
void CpuTraversal::orderByLight(const ShadowQueue &shadows) {
  mOrder.clear();
  size_t longest = 1;
  for (size_t rank = 0; rank < longest; ++rank) {
    for (size_t i = 0, inRow = 0; i < shadows.size(); ++i) {
      inRow = i > 0 && shadows.pixel[i] == shadows.pixel[i - 1] ? inRow + 1 : 0;
      longest = std::max(longest, inRow + 1);
      if (inRow == rank) mOrder.push_back(static_cast<uint32_t>(i));
    }
  }
}

void CpuTraversal::addVisible(const SceneView &scene, const ShadowQueue &shadows, std::span<Rgb> sum) {
  const size_t count = shadows.size();
  orderByLight(shadows);
  mOrigin.resize(0);
  mDirection.resize(0);
  mEnd.clear();
  for (const uint32_t i : mOrder) {
    mOrigin.push(shadows.origin[i]);
    mDirection.push(shadows.direction[i]);
    mEnd.push_back(shadowEnd(shadows.distance[i]));
  }
  mBlocked.resize(count);
  mBlockedInOrder.resize(count);
  findBlocked(scene,
              {{mOrigin.x.data(), mOrigin.y.data(), mOrigin.z.data()},
               {mDirection.x.data(), mDirection.y.data(), mDirection.z.data()},
               count},
              mEnd.data(), mBlockedInOrder.data());
  for (size_t i = 0; i < count; ++i) mBlocked[mOrder[i]] = mBlockedInOrder[i];
  // Sums in the order of the queue, as every device.
  for (size_t i = 0; i < count; ++i) {
    if (mBlocked[i]) continue;
    const ShadowItem item = shadows[i];
    sum[item.pixel] += item.colour * throughFilters(scene, item.ray, shadowEnd(item.distance));
  }
}

}  // namespace rc::ddi::cpu
