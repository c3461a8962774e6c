// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A whole program whose n-th allocation fails, for each n, for once and from then on: every call ends in its result or
// in RC_OUT_OF_MEMORY or EGL_BAD_ALLOC, nothing is lost, and the same context draws the right picture afterwards.
// The quick program takes some n, the slow one all.
#include <gtest/gtest.h>

#include <ostream>

#include "api/allocation_failure.h"
#include "base/memory.h"
#include "egl/shortage_program.h"

namespace rc::test {
namespace {

#ifdef RAYCORE_EVERY_ALLOCATION
int stepOf(int step) { return std::max(1, step / 50); }  // all, or every ninth of many thousands
#define RAYCORE_SHORTAGE EveryShortage
#else
int stepOf(int step) { return step; }
#define RAYCORE_SHORTAGE SomeShortage
#endif

struct Case {
  const char *name;
  int step;  // of the quick program
  ShortageScene scene;
  Shortage shortage;
};

void PrintTo(const Case &value, std::ostream *out) { *out << value.name; }

class ShortageTest : public testing::TestWithParam<Case> {
 protected:
  // Static tables fill at the first time.
  void SetUp() override {
    for (int i = 0; i < 2; ++i) {
      ShortageProgram program(GetParam().scene);
      ASSERT_TRUE(program.open());
      program.draw();
      ASSERT_EQ(program.shortages(), 0);
      ASSERT_EQ(program.otherError(), RCenum(RC_NO_ERROR));
      mTruth = program.picture();
      program.close();
    }
  }

  // Whether the n-th allocation was asked for.
  bool starve(int n) {
    ShortageProgram program(GetParam().scene);
    failAnyAllocationAfter(n, GetParam().shortage);
    const bool opened = program.open();
    if (opened) program.draw();
    const bool failed = allocationFailed();
    if (!opened) {
      EXPECT_EQ(program.error(), EGL_BAD_ALLOC);
    } else {
      // What fails in the workers' own library may be done without: then the picture is right at once.
      if (program.shortages() == 0) {
        EXPECT_EQ(program.picture(), mTruth);
      } else {
        EXPECT_TRUE(failed);
      }
      // A texture that could not be loaded has no part to replace.
      if (!failed) {
        EXPECT_EQ(program.otherError(), RCenum(RC_NO_ERROR));
      }
      program.draw();
      EXPECT_EQ(program.shortages(), 0);
      EXPECT_EQ(program.otherError(), RCenum(RC_NO_ERROR));
      EXPECT_EQ(program.picture(), mTruth);
    }
    program.close();
    return failed;
  }

  ShortageProgram::Picture mTruth{};
};

TEST_P(ShortageTest, IsReportedAndLeavesNothingBehind) {
  const long live = liveAllocations();
  const size_t counted = countedMemory();
  int n = 0;
  for (; starve(n); n += stepOf(GetParam().step)) {
    ASSERT_FALSE(HasFailure()) << "allocation " << n;
    ASSERT_EQ(liveAllocations(), live) << "allocation " << n;
    ASSERT_EQ(countedMemory(), counted) << "allocation " << n;
  }
  EXPECT_GT(n, 100) << "hardly anything was tried";
  RecordProperty("allocations", n);
}

INSTANTIATE_TEST_SUITE_P(RAYCORE_SHORTAGE, ShortageTest,
                         testing::Values(Case{"BvhOnce", 7, {RC_STRUCTURE_BVH, false}, Shortage::Once},
                                         Case{"BvhLasting", 7, {RC_STRUCTURE_BVH, false}, Shortage::Lasting},
                                         Case{"KdTreeOnce", 499, {RC_STRUCTURE_KD_TREE, false}, Shortage::Once},
                                         Case{"KdTreeLasting", 499, {RC_STRUCTURE_KD_TREE, false}, Shortage::Lasting},
                                         Case{"CurveOnce", 13, {RC_STRUCTURE_BVH, true}, Shortage::Once},
                                         Case{"CurveLasting", 13, {RC_STRUCTURE_BVH, true}, Shortage::Lasting}),
                         [](const auto &shortage) { return std::string(shortage.param.name); });

}  // namespace
}  // namespace rc::test
