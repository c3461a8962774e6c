// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// hits.h: the hits of every acceleration structure against those of trying all triangles.
#pragma once

#include <gtest/gtest.h>

#include "common/meshes.h"

namespace rc::test {

inline std::vector<hal::Hit> hitsWith(AccelKind kind, const Triangles &triangles, std::span<const hal::Ray> rays) {
  TestScene scene(triangles, kind);
  std::vector<hal::Hit> hits(rays.size());
  hal::createDevice("cpu", 0)->intersect(scene.update(), rays, hits);
  return hits;
}

inline size_t expectSame(const std::vector<hal::Hit> &found, const std::vector<hal::Hit> &truth, const char *what) {
  size_t hits = 0, different = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    hits += truth[i].found();
    const bool same = found[i].primitive == truth[i].primitive &&
                      (!truth[i].found() || std::abs(found[i].t - truth[i].t) <= 1e-5f * truth[i].t);
    if (!same && ++different <= 3) {
      ADD_FAILURE() << what << ", ray " << i << ": primitive " << found[i].primitive << " at " << found[i].t
                    << ", should be " << truth[i].primitive << " at " << truth[i].t;
    }
  }
  EXPECT_EQ(different, 0u) << what;
  return hits;
}

inline void compareAll(const Triangles &triangles, size_t rayCount) {
  const std::vector<hal::Ray> rays = randomRays(rayCount, 7);
  const std::vector<hal::Hit> truth = hitsWith(AccelKind::Exhaustive, triangles, rays);
  const size_t hits = expectSame(hitsWith(AccelKind::KdTree, triangles, rays), truth, "kd-tree");
  expectSame(hitsWith(AccelKind::Bvh, triangles, rays), truth, "BVH");
  EXPECT_GT(hits, rayCount / 20) << "the rays miss nearly everything: nothing is tested";
}

}  // namespace rc::test
