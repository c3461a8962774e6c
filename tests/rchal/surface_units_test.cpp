// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The units that decide how much of a surface is seen: coverage and fog, against what can be calculated by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "rchal/units/coverage.h"
#include "rchal/units/fog.h"

namespace rc::test {
namespace {

using namespace rc::hal;

TEST(Coverage, AllAlphaTests) {
  for (uint32_t outcomes = 0; outcomes < 8; ++outcomes) {
    for (int reference : {0, 1, 127, 254, 255}) {
      const uint32_t flags = alphaTestFlags(outcomes, float(reference) / 255);
      EXPECT_EQ(flags & ~(kAlphaTestMask | 0x00ff0000u), 0u) << "other flags are left alone";
      for (int level : {0, 1, 126, 127, 128, 254, 255}) {
        const uint32_t outcome = level < reference ? kAlphaLess : level == reference ? kAlphaEqual : kAlphaGreater;
        EXPECT_EQ(passesAlphaTest(flags, float(level) / 255), (outcomes & outcome) != 0)
            << outcomes << ": " << level << " against " << reference;
      }
    }
  }
}

TEST(Coverage, NoTestIsNoFlag) {
  EXPECT_EQ(alphaTestFlags(7, 0.5f), 0u);
  EXPECT_NE(alphaTestFlags(0, 0) & kFiltersShadow, 0u);
  EXPECT_TRUE(passesAlphaTest(0, 0));
}

TEST(Coverage, ReferencesAreClamped) {
  EXPECT_EQ(alphaTestFlags(kAlphaLess, 7), alphaTestFlags(kAlphaLess, 1));
  EXPECT_EQ(alphaTestFlags(kAlphaLess, -7), alphaTestFlags(kAlphaLess, 0));
}

TEST(Coverage, CulledSidesAndTransparentTexels) {
  for (float opacity : {0.0f, 0.25f, 1.0f}) {
    EXPECT_EQ(coverage(0, true, opacity), opacity);
    EXPECT_EQ(coverage(0, false, opacity), opacity);
    EXPECT_EQ(coverage(kCullFront, true, opacity), 0);
    EXPECT_EQ(coverage(kCullFront, false, opacity), opacity);
    EXPECT_EQ(coverage(kCullBack, true, opacity), opacity);
    EXPECT_EQ(coverage(kCullBack, false, opacity), 0);
    EXPECT_EQ(coverage(kCullFront | kCullBack, true, opacity), 0);
  }
  const uint32_t atLeastHalf = alphaTestFlags(kAlphaEqual | kAlphaGreater, 0.5f);
  EXPECT_EQ(coverage(atLeastHalf, true, 0.75f), 0.75f);
  EXPECT_EQ(coverage(atLeastHalf, true, 0.25f), 0);
}

TEST(Fog, Transmission) {
  const Fog off;
  EXPECT_EQ(fogTransmission(off, 1e9f), 1);
  const Fog linear{.mode = FogMode::Linear, .start = 10, .end = 30};
  for (const auto &[distance, left] : {std::pair{0.0f, 1.0f}, {10, 1}, {15, 0.75f}, {30, 0}, {99, 0}}) {
    EXPECT_FLOAT_EQ(fogTransmission(linear, distance), left) << distance;
  }
  const Fog turned{.mode = FogMode::Linear, .start = 30, .end = 10};  // GL's formula as it stands
  EXPECT_FLOAT_EQ(fogTransmission(turned, 15), 0.25f);
  const Fog exp{.mode = FogMode::Exp, .density = 0.5f}, exp2{.mode = FogMode::Exp2, .density = 0.5f};
  EXPECT_FLOAT_EQ(fogTransmission(exp, 3), std::exp(-1.5f));
  EXPECT_FLOAT_EQ(fogTransmission(exp2, 3), std::exp(-2.25f));
  EXPECT_EQ(fogTransmission(exp, kInfinity), 0);
}

TEST(Fog, AStepHasNoDivision) {
  const Fog step{.mode = FogMode::Linear, .start = 5, .end = 5};
  EXPECT_EQ(fogTransmission(step, 4.9f), 1);
  EXPECT_EQ(fogTransmission(step, 5.1f), 0);
}

// However many mirrors the way has.
TEST(Fog, LegsOfTheWayMakeTheWhole) {
  for (const FogMode mode : {FogMode::Linear, FogMode::Exp, FogMode::Exp2}) {
    const Fog fog{.mode = mode, .density = 0.02f, .start = 3, .end = 80};
    float travelled = 0, left = 1;
    for (float leg : {1.0f, 10.0f, 25.0f, 4.0f}) {
      left *= fogLeft(fog, travelled, leg, travelled == 0);
      travelled += leg;
    }
    EXPECT_NEAR(left, fogTransmission(fog, 40), 1e-6);
  }
}

// At the eye there is fog already, or it thins out: the first leg is as GL's formula has it.
TEST(Fog, TheFirstLegIsTheWholeWay) {
  for (const auto &[start, end] : {std::pair{-40.0f, 40.0f}, {60, 0}}) {
    const Fog fog{.mode = FogMode::Linear, .start = start, .end = end};
    EXPECT_FLOAT_EQ(fogLeft(fog, 0, 20, true), fogTransmission(fog, 20));
    EXPECT_LE(fogLeft(fog, 20, 20, false), 1) << "fog takes no light away";
  }
}

TEST(Fog, BehindOpaqueFogNothingIsLeft) {
  const Fog fog{.mode = FogMode::Linear, .start = 0, .end = 10};
  EXPECT_EQ(fogLeft(fog, 0, 20, true), 0);
  EXPECT_EQ(fogLeft(fog, 20, 20, false), 0) << "not a number otherwise";
}

// Parallel rays start behind the eye: what they meet there is at no distance from it.
TEST(Fog, BehindTheEyeThereIsNone) {
  const Fog fog{.mode = FogMode::Exp, .density = 0.5f};
  EXPECT_EQ(fogLeft(fog, -30, 20, true), 1);
  EXPECT_FLOAT_EQ(fogLeft(fog, -30, 33, true), std::exp(-1.5f));
}

}  // namespace
}  // namespace rc::test
