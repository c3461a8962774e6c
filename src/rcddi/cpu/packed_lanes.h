// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// packed_lanes.h: numbers of lanes, in tables that vectors are loaded from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rc::ddi::cpu {

struct alignas(64) LaneNumbers {
  uint32_t numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
};
inline constexpr LaneNumbers kLaneNumbers;

using LaneOrder = std::array<uint32_t, 8>;

// For each mask of up to eight lanes: which lanes are set, from the first on; then zeros.
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
