// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/instruction_set.h"

#include <hwy/targets.h>

#include <cstdint>

namespace rc {
namespace {

struct Row {
  std::string_view name;
  int64_t target;
};
constexpr Row kRows[] = {
    {"baseline", HWY_EMU128}, {"ssse3", HWY_SSSE3}, {"sse4", HWY_SSE4}, {"avx2", HWY_AVX2}, {"avx512", HWY_AVX3}};

}  // namespace

// Highway numbers better targets lower.
void limitInstructionSet(std::string_view name) {
  for (const Row &row : kRows) {
    if (row.name == name) hwy::DisableTargets(row.target - 1);
  }
}

}  // namespace rc
