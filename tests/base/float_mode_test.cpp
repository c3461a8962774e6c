// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The mode for floats inside, whatever it is outside, on all threads; and outside again as it was.
#include "base/float_mode.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace rc::test {
namespace {

// Computed when the program runs.
float half(float x) {
  const volatile float value = x;
  return value * 0.5f;
}
bool roundsToNearest() {
  const volatile float one = 1, little = 0x1p-25f;
  const volatile float sum = one + little, difference = -one - little;
  return sum == 1 && difference == -1;
}
bool keepsDenormals() { return half(std::numeric_limits<float>::min()) > 0; }

class FloatModes : public testing::Test {
 protected:
  void SetUp() override { std::fegetenv(&mOld); }
  void TearDown() override { std::fesetenv(&mOld); }

  std::fenv_t mOld;
};

TEST_F(FloatModes, RoundingIsOursInsideAndTheProgramsOutside) {
  std::fesetround(FE_UPWARD);
  ASSERT_FALSE(roundsToNearest());
  {
    const FloatMode mode;
    EXPECT_TRUE(roundsToNearest());
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_FALSE(roundsToNearest());
}

#if defined(__SSE__)
TEST_F(FloatModes, DenormalNumbersAreKeptInside) {
  _mm_setcsr(_mm_getcsr() | 0x8040);
  ASSERT_FALSE(keepsDenormals());
  {
    const FloatMode mode;
    EXPECT_TRUE(keepsDenormals());
  }
  EXPECT_FALSE(keepsDenormals());
}

TEST_F(FloatModes, NothingTrapsAndFlagsAreTheProgramsOwn) {
  std::feclearexcept(FE_ALL_EXCEPT);
  _mm_setcsr(_mm_getcsr() & ~0x1f80u);  // all traps on
  const uint32_t before = _mm_getcsr();
  {
    const FloatMode mode;
    const volatile float zero = 0, one = 1;
    EXPECT_FALSE(std::isfinite(one / zero));
  }
  EXPECT_EQ(_mm_getcsr(), before);
}
#endif

TEST_F(FloatModes, WorkersHaveItToo) {
  std::fesetround(FE_UPWARD);
  const Workers workers(3);
  std::atomic<int> wrong = 0;
  workers.forEach(200, [&](size_t, int) { wrong += !roundsToNearest() || !keepsDenormals(); });
  workers.run([&] { both([&] { wrong += !roundsToNearest(); }, [&] { wrong += !roundsToNearest(); }); });
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
}

}  // namespace
}  // namespace rc::test
