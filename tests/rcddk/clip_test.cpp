// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Clipping of random triangles, against a test of points that knows nothing of polygons. [Sutherland, Hodgman 1974]
#include "rcddk/clip.h"

#include <gtest/gtest.h>

#include <random>

namespace rc::test {
namespace {

using ddk::Clipper;
using ddk::Corner;

class ClipperTest : public testing::Test {
 protected:
  float number() { return std::uniform_real_distribution<float>(-1, 1)(mRandom); }
  Vec3 point() {
    const float x = number(), y = number(), z = number();
    return {x, y, z};
  }
  // What is interpolated is a linear function of the position: it must stay so.
  static Corner cornerAt(const Vec3 &p) { return {p, 2.0f * p + 1.0f, Vec2(p.x - p.z, 3 * p.y), Rgb(p.y, p.z, p.x)}; }
  std::array<Corner, 3> triangle() { return {cornerAt(point()), cornerAt(point()), cornerAt(point())}; }
  std::vector<Vec4> planes(size_t count) {
    std::vector<Vec4> all;
    for (size_t i = 0; i < count; ++i) all.push_back(Vec4(point(), 0.5f * number()));
    return all;
  }
  static double height(const Vec4 &plane, const Vec3 &p) {
    return double(plane.x) * p.x + double(plane.y) * p.y + double(plane.z) * p.z + plane.w;
  }
  static Vec3 areaVector(std::span<const Corner> polygon) {
    Vec3 sum(0);
    for (size_t i = 2; i < polygon.size(); ++i) {
      sum +=
          0.5f * glm::cross(polygon[i - 1].position - polygon[0].position, polygon[i].position - polygon[0].position);
    }
    return sum;
  }
  // Whether a point of the triangle's plane lies in the polygon, which has the triangle's winding.
  static bool contains(std::span<const Corner> polygon, const Vec3 &normal, const Vec3 &p) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 a = polygon[i].position, b = polygon[(i + 1) % polygon.size()].position;
      if (glm::dot(glm::cross(b - a, p - a), normal) < 0) return false;
    }
    return polygon.size() >= 3;
  }

  std::mt19937 mRandom{71};
  Clipper mClipper;
};

TEST_F(ClipperTest, APointStaysIfItIsInFrontOfEveryPlane) {
  size_t inside = 0, outside = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::array<Corner, 3> corners = triangle();
    const std::vector<Vec4> all = planes(size_t(round % 7));
    const Vec3 normal =
        glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position);
    const std::span<const Corner> left = mClipper.clip(corners, all);
    for (int i = 0; i < 20; ++i) {
      float u = std::abs(number()), v = std::abs(number());
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 p = corners[0].position + u * (corners[1].position - corners[0].position) +
                     v * (corners[2].position - corners[0].position);
      double lowest = 1;
      for (const Vec4 &plane : all) lowest = std::min(lowest, height(plane, p));
      const bool nearAnEdge = std::min({u, v, 1 - u - v}) < 1e-3f || std::abs(lowest) < 1e-3;
      if (nearAnEdge || glm::length(normal) < 0.05f) continue;
      ASSERT_EQ(contains(left, normal, p), lowest > 0) << "round " << round << " point " << i;
      ++(lowest > 0 ? inside : outside);
    }
  }
  EXPECT_GT(inside, 2000u);
  EXPECT_GT(outside, 2000u);
}

TEST_F(ClipperTest, BothSidesOfAPlaneMakeTheWhole) {
  for (int round = 0; round < 2000; ++round) {
    const std::array<Corner, 3> corners = triangle();
    const std::vector<Vec4> front = planes(1), back{-front[0]};
    const Vec3 whole = areaVector(corners);
    const Vec3 sum = areaVector(mClipper.clip(corners, front)) + areaVector(mClipper.clip(corners, back));
    ASSERT_NEAR(glm::length(sum - whole), 0, 1e-5) << round;
  }
}

TEST_F(ClipperTest, WhatIsInterpolatedStaysLinear) {
  for (int round = 0; round < 2000; ++round) {
    for (const Corner &corner : mClipper.clip(triangle(), planes(6))) {
      const Corner expected = cornerAt(corner.position);
      ASSERT_NEAR(glm::length(corner.normal - expected.normal), 0, 1e-5);
      ASSERT_NEAR(glm::length(corner.uv - expected.uv), 0, 1e-5);
      ASSERT_NEAR(glm::length(corner.color - expected.color), 0, 1e-5);
    }
  }
}

// Two triangles of a surface must not come apart where they are cut.
TEST_F(ClipperTest, NeighboursAreCutAtTheSamePoint) {
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Vec4> all = planes(1);
    const Corner a = cornerAt(point()), b = cornerAt(point()), c = cornerAt(point()), d = cornerAt(point());
    const auto cutsOf = [&](const std::array<Corner, 3> &corners) {
      std::vector<Vec3> cuts;
      for (const Corner &corner : mClipper.clip(corners, all)) cuts.push_back(corner.position);
      return cuts;
    };
    const bool crossed = (height(all[0], a.position) > 0) != (height(all[0], b.position) > 0);
    if (!crossed) continue;
    const std::vector<Vec3> one = cutsOf({a, b, c}), other = cutsOf({b, a, d});
    size_t common = 0;
    for (const Vec3 &p : one) common += std::count(other.begin(), other.end(), p) > 0;
    ASSERT_GE(common, 2u) << "the end in front and the cut, in round " << round;
  }
}

TEST_F(ClipperTest, OnThePlaneIsInFront) {
  const std::array<Corner, 3> corners{cornerAt({0, 0, 0}), cornerAt({1, 0, 0}), cornerAt({0, 1, 0})};
  EXPECT_EQ(mClipper.clip(corners, std::array{Vec4(0, 0, 1, 0)}).size(), 3u);
  EXPECT_EQ(mClipper.clip(corners, std::array{Vec4(0, 0, 0, 0)}).size(), 3u);
  EXPECT_EQ(mClipper.clip(corners, std::array{Vec4(0, 0, 1, -1)}).size(), 0u);
  EXPECT_EQ(mClipper.clip(corners, std::array{Vec4(1, 0, 0, -0.5f)}).size(), 3u);
  EXPECT_EQ(mClipper.clip(corners, std::array{Vec4(-1, 0, 0, 0.5f)}).size(), 4u);
  EXPECT_EQ(mClipper.clip(corners, std::span<const Vec4>()).size(), 3u);
}

TEST_F(ClipperTest, NumbersThatAreNoneHarmNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  for (float bad : {nan, infinite, -infinite}) {
    EXPECT_LE(mClipper.clip(triangle(), std::vector<Vec4>(6, Vec4(bad, 1, 1, bad))).size(), 9u);
  }
}

}  // namespace
}  // namespace rc::test
