// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Each limit leaves nothing better than itself; what a machine lacks becomes what it has.
#include "base/instruction_set.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace rc::test {
namespace {

class InstructionSet : public testing::Test {
 protected:
  void TearDown() override { hwy::DisableTargets(0); }

  // Of the best one, smaller is better.
  static int64_t best() { return hwy::SupportedTargets() & -hwy::SupportedTargets(); }
};

TEST_F(InstructionSet, NoneBetterIsLeft) {
  const int64_t all = best();
  limitInstructionSet("");
  EXPECT_EQ(best(), all);
  int64_t last = all;
  for (const auto &[name, target] : {std::pair{"avx512", HWY_AVX3},
                                     {"avx2", HWY_AVX2},
                                     {"sse4", HWY_SSE4},
                                     {"ssse3", HWY_SSSE3},
                                     {"baseline", HWY_EMU128}}) {
    limitInstructionSet(name);
    EXPECT_GE(best(), std::max<int64_t>(target, last)) << name;
    last = best();
  }
}

}  // namespace
}  // namespace rc::test
