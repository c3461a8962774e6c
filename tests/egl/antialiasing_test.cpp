// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// How near pictures of few samples a pixel come to one of 64 by the reference device: each step must pay.
#include <gtest/gtest.h>

#include <cmath>

#include "images/run_example.h"

namespace rc::test {
namespace {

// Peak signal to noise ratio in decibels.
double psnr(const Picture &a, const Picture &b) {
  double sum = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(double(a.rgb[i]) - b.rgb[i], 2);
  return 10 * std::log10(255.0 * 255.0 * double(a.rgb.size()) / sum);
}

class Antialiasing : public testing::TestWithParam<const char *> {};

TEST_P(Antialiasing, MoreSamplesComeNearerToManyOfTheReference) {
  const Picture reference = runExample(GetParam(), 1, "RAYCORE_DEVICE=ref RAYCORE_SAMPLES=64").picture;
  ASSERT_EQ(reference.width, 800);
  double before = 0;
  for (const char *samples : {"1", "4", "8", "16"}) {
    const Picture picture = runExample(GetParam(), 1, std::string("RAYCORE_SAMPLES=").append(samples)).picture;
    ASSERT_EQ(picture.rgb.size(), reference.rgb.size());
    const double now = psnr(picture, reference);
    RecordProperty(std::string("psnr_").append(samples), std::to_string(now));
    EXPECT_GT(now, before + 2) << samples << " samples";
    before = now;
  }
  EXPECT_GT(before, 55);
}

INSTANTIATE_TEST_SUITE_P(Guide, Antialiasing, testing::Values("02_5a_perspective", "06_5c_refraction"));

}  // namespace
}  // namespace rc::test
