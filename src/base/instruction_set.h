// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// instruction_set.h: the best instruction set that kernels may use: RAYCORE_INSTRUCTION_SET. Those who look for slips
// lower it, and tools that do not know the newest one.
#pragma once

#include <string_view>

namespace rc {

// From now on nothing better than this one is used, in the whole process: "baseline", "ssse3", "sse4",
// "avx2", "avx512"; an empty name changes nothing. A machine
// that lacks it uses the next one that it has.
void limitInstructionSet(std::string_view name);

}  // namespace rc
