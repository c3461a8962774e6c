// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// trace.h: traversal and intersection for many rays at a time, in the widest instructions the machine has.
// In: SceneView, rays in columns.  Out: Hits, equal to those of units/traversal.h bit by bit.  Next:
// rchal/tile_tracer.h
//
// Rays that follow each other should lie beside each other: they are looked at in groups, blocks of 16.
#pragma once

#include <array>

#include "rcddi/cpu/filter_hits.h"
#include "rchal/queues.h"
#include "rchal/units/traversal.h"

namespace rc::ddi::cpu {

// Columns can be read up to a multiple of kPacket. What lies there counts for nothing, but rays like the last one keep
// those of a group together: see pad().
struct RayStream {
  std::array<const float *, 3> origin, direction;
  size_t count;
  // The triangles that rays start or end on, off their planes by SurfacePoint::safeOffset or more, so that they cannot
  // meet them: tests with them may be left out. Null: not known; kNoPrimitive: none.
  const uint32_t *from = nullptr;
  bool common = false;  // all rays start at one point, which `origin` has for those of a group, and need not for more
  hal::Reach reach{};   // of those that ask what blocks them

  static constexpr size_t kPacket = 16, kGroup = 512;

  // Repeats the last of a column's values up to a multiple of kPacket.
  template <class T>
  static void pad(T *values, size_t count) {
    for (size_t i = count; i % kPacket; ++i) values[i] = values[count - 1];
  }
};

// The nearest hit of each ray: hits become as many.
void closestHits(const hal::SceneView &scene, const RayStream &rays, hal::HitQueue &hits);

// blocked[i] = 1 if a triangle that lets no light through lies within the reach of ray i, else 0. filters, unless null:
// receives where rays that are not blocked cross the others.
void findBlocked(const hal::SceneView &scene, const RayStream &rays, uint8_t *blocked, FilterHits *filters);

}  // namespace rc::ddi::cpu
