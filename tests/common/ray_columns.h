// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_columns.h: what tests and benches need to call the kernels of the cpu device: rays in columns, and each of the
// instruction sets that the machine has.
#pragma once

#include <hwy/targets.h>

#include <span>
#include <vector>

#include "rcddi/cpu/trace.h"

namespace rc::test {

struct Columns {
  static constexpr size_t kBehind = 15;  // values that may be read behind the last one

  std::vector<float> values[6];

  explicit Columns(std::span<const hal::Ray> rays) {
    for (const hal::Ray &ray : rays) {
      for (int axis = 0; axis < 3; ++axis) {
        values[axis].push_back(ray.origin[axis]);
        values[3 + axis].push_back(ray.direction[axis]);
      }
    }
    for (auto &column : values) column.resize(rays.size() + kBehind, rays.empty() ? 0 : column.back());
  }
  ddi::cpu::RayStream stream() const {
    return {{values[0].data(), values[1].data(), values[2].data()},
            {values[3].data(), values[4].data(), values[5].data()},
            values[0].size() - kBehind};
  }
};

// By the kernels.
inline std::vector<hal::Hit> closestHits(const hal::SceneView &scene, const Columns &columns) {
  hal::HitQueue queue;
  ddi::cpu::closestHits(scene, columns.stream(), queue);
  std::vector<hal::Hit> hits;
  for (size_t i = 0; i < queue.size(); ++i) hits.push_back(queue[i]);
  return hits;
}

// use(name) with each of them alone; the best one is chosen afterwards again.
template <class Use>
void forEachTarget(Use &&use) {
  const int64_t all = hwy::SupportedTargets();
  for (int64_t rest = all; rest != 0; rest &= rest - 1) {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    use(hwy::TargetName(rest & -rest));
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace rc::test
