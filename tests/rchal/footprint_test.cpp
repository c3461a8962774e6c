// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Stretched footprints on a plane whose texture coordinates are its positions. [units/footprint.h]
#include "rchal/units/footprint.h"

#include <gtest/gtest.h>

namespace rc::hal {
namespace {

class FootprintTest : public testing::Test {
 protected:
  static constexpr int kSide = 64;

  FootprintTest() {
    triangle.v1 = {1, 0, 0};
    triangle.v2 = {0, 1, 0};
    attributes.uv[0] = {0, 0};
    attributes.uv[1] = {1, 0};
    attributes.uv[2] = {0, 1};
    setPlane(triangle);
    texture.width = texture.height = kSide;
    texture.levelCount = 7;
    texture.anisotropy = 16;
  }
  // Of a ray that comes down on the plane at this cosine, towards +x.
  Footprint at(float cosine, float width) const {
    const Vec3 direction(std::sqrt(1 - cosine * cosine), 0, -cosine);
    return stretchedFootprint(triangle, attributes, texture, {0, 0, 1}, direction, width);
  }
  HotTriangle triangle{};
  TriangleAttributes attributes{};
  TextureView texture;
};

TEST_F(FootprintTest, IsRoundFromAbove) {
  const Footprint footprint = at(1, 8.0f / kSide);
  EXPECT_EQ(footprint.probes, 1);
  EXPECT_NEAR(footprint.lod, 3, 1e-3f);
}

TEST_F(FootprintTest, IsStretchedAlongASlantedRay) {
  const Footprint footprint = at(0.26f, 8.0f / kSide);
  EXPECT_EQ(footprint.probes, 4) << "3.85 times as long as wide";
  EXPECT_NEAR(footprint.lod, std::log2(8 / 0.26f / 4), 1e-2f);
  EXPECT_NEAR(std::abs(footprint.axis.x), 8 / 0.26f / kSide, 1e-4f);
  EXPECT_NEAR(footprint.axis.y, 0, 1e-6f);
}

TEST_F(FootprintTest, IsReadByNoMoreProbesThanTheTextureAllows) {
  texture.anisotropy = 2;
  const Footprint footprint = at(0.26f, 8.0f / kSide);
  EXPECT_EQ(footprint.probes, 2);
  EXPECT_NEAR(footprint.lod, std::log2(8 / 0.26f / 2), 1e-2f) << "blurred as far as two do not reach";
}

TEST_F(FootprintTest, IsStretchedWhereTheTextureIs) {
  attributes.uv[2] = {0, 5};  // five times as many texels along y
  const Footprint footprint = at(1, 8.0f / kSide);
  EXPECT_EQ(footprint.probes, 5);
  EXPECT_NEAR(footprint.lod, 3, 1e-2f);
  EXPECT_NEAR(std::abs(footprint.axis.y), 5 * 8.0f / kSide, 1e-4f);
  EXPECT_NEAR(footprint.axis.x, 0, 1e-6f);
}

TEST_F(FootprintTest, HasNoMoreProbesThanTexels) {
  EXPECT_EQ(at(0.01f, 0.02f / kSide).probes, 2) << "two texels long";
  EXPECT_EQ(at(0.1f, 0.02f / kSide).probes, 1) << "magnified";
}

TEST_F(FootprintTest, WhatIsNoNumberIsOneProbe) {
  for (const float width : {std::nanf(""), kInfinity, 0.0f}) {
    const Footprint footprint = at(0.5f, width);
    EXPECT_GE(footprint.probes, 1);
    EXPECT_LE(footprint.probes, 16);
  }
  attributes.uv[1] = attributes.uv[2] = attributes.uv[0];
  EXPECT_EQ(at(0.5f, 1).probes, 1) << "one texel all over";
}

// A texture of white and black columns, half of each: the mean over its width is grey.
TEST_F(FootprintTest, TakesTheMeanOverItsAxis) {
  std::vector<uint32_t> texels;
  for (int i = 0; i < kSide * kSide; ++i) texels.push_back(i % kSide < kSide / 2 ? 0xff000000 : 0xffffffff);
  texture.levels[0] = texels.data();
  texture.levelCount = 1;
  const Wraps wraps{Wrap::ClampToEdge, Wrap::ClampToEdge};
  const auto red = [&](const Vec2 &uv, const Vec2 &axis) {
    return sampleFootprint(texture, uv, wraps, {0, 8, axis}).x;
  };
  EXPECT_FLOAT_EQ(red({0.5f, 0.5f}, {0.5f, 0}), 0.5f);
  EXPECT_FLOAT_EQ(red({0.625f, 0.5f}, {0.5f, 0}), 0.75f);
  EXPECT_FLOAT_EQ(red({0.75f, 0.5f}, {0, 0.5f}), 1);
}

}  // namespace
}  // namespace rc::hal
