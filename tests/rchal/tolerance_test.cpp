// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What may be left out behind a hit is shared, and nothing of it is given away twice.
#include "rchal/units/tolerance.h"

#include <gtest/gtest.h>

#include <random>

namespace rc::test {
namespace {

using namespace rc::hal;

// What two rays of these weights may lack together: one that is left out all, one that is traced what it may leave out.
float mostLacking(float reflected, float refracted, float tolerance, const TwoShares &shares) {
  const float ofReflected = besides(tolerance, refracted, shares.refracted);
  const float ofRefracted = besides(tolerance, reflected, shares.reflected);
  return std::min(reflected, ofReflected) + std::min(refracted, ofRefracted);
}

TEST(Tolerance, TwoRaysNeverLackMoreThanTheyMay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const float share = unit(random), tolerance = std::pow(unit(random), 4.0f);
    const float reflected = std::pow(unit(random), 4.0f), refracted = std::pow(unit(random), 4.0f);
    EXPECT_LE(mostLacking(reflected, refracted, tolerance, {share, 1 - share}), tolerance * 1.000001f);
  }
}

TEST(Tolerance, ARayThatIsLeftOutLeavesTheRestToTheOther) {
  EXPECT_FLOAT_EQ(besides(1, 0.25f, 0.5f), 0.75f);
  EXPECT_FLOAT_EQ(besides(1, 3, 0.5f), 0.5f);  // it is traced, and keeps its share
  EXPECT_FLOAT_EQ(besides(1, 0, 0), 1);        // there is no other
}

TEST(Tolerance, TheLighterRayMayLackMore) {
  const auto shares = [](float reflection, float transmittance) {
    return sharesOf({.reflection = Rgb(reflection), .transmittance = Rgb(transmittance)});
  };
  EXPECT_FLOAT_EQ(shares(0.04f, 0.64f).reflected, 0.8f);
  EXPECT_FLOAT_EQ(shares(0.04f, 0.64f).refracted, 0.2f);
  EXPECT_FLOAT_EQ(shares(0.5f, 0.5f).reflected, 0.5f);
  EXPECT_EQ(shares(0, 0).reflected, 0);
}

TEST(Tolerance, WhatGoesStraightOnGetsAsMuchAsEachOther) {
  EXPECT_FLOAT_EQ(straightShare(0), 1);
  EXPECT_FLOAT_EQ(straightShare(2), 1.0f / 3);
}

TEST(Tolerance, LightWeighsWhatTheRayWouldThatBringsIt) {
  SceneView scene;
  scene.ignorable = kStep / 4;  // rays bring four times white at the most
  EXPECT_FLOAT_EQ(weightOf(scene, 4), 1);
  EXPECT_FLOAT_EQ(weightOf(scene, 0.5f), 0.125f);
  scene.ignorable = 0;  // nothing bounds what they bring
  EXPECT_EQ(weightOf(scene, 100), 0);
}

}  // namespace
}  // namespace rc::test
