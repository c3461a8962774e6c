// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// traversal.h: how the cpu device answers a tile's questions to the traversal unit: queues to streams.
// In: RayQueue, ShadowQueue.  Out: HitQueue, sums.  Next: rcddi/cpu/trace.h
#pragma once

#include "rcddi/cpu/trace.h"
#include "rchal/queues.h"

namespace rc::ddi::cpu {

// One for each worker; its memory is used again from tile to tile.
class CpuTraversal {
 public:
  void closestHits(const hal::SceneView &scene, const hal::RayQueue &rays, hal::HitQueue &hits) const;
  void addVisible(const hal::SceneView &scene, const hal::ShadowQueue &shadows, std::span<Rgb> sum);

 private:
  void orderByLight(const hal::ShadowQueue &shadows);

  std::vector<uint32_t> mOrder;  // places in the shadow queue
  hal::Vec3Column mOrigin, mDirection;
  std::vector<float> mEnd;
  std::vector<uint8_t> mBlocked, mBlockedInOrder;
};

}  // namespace rc::ddi::cpu
