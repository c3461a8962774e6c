// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// packed_lanes.h: for each mask of up to eight lanes: which lanes are set, from the first on; then zeros.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rc::ddi::cpu {

using LaneOrder = std::array<uint32_t, 8>;

inline constexpr std::array<LaneOrder, 256> kPackedLanes = [] {
  std::array<LaneOrder, 256> table{};
  for (size_t mask = 0; mask < table.size(); ++mask) {
    size_t count = 0;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      if (mask >> lane & 1) table[mask][count++] = lane;
    }
  }
  return table;
}();

}  // namespace rc::ddi::cpu
