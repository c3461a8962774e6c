// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Triangles side by side come out as GLM and the scalar functions make them one by one, to the last bit, on every
// instruction set.
#include "rcddk/vertex_stage.h"

#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <random>
#include <vector>

#include "common/ray_columns.h"
#include "rchal/scene_view.h"

namespace rc::test {
namespace {

using ddk::TriangleColumns;
using Columns = float[3][TriangleColumns::kRoom];

const Mat4 kMatrix = glm::rotate(glm::translate(Mat4(1), Vec3(3, -0.1f, 1e4f)), 0.7f, Vec3(1, 2, 3));
const glm::mat3 kNormalMatrix(0.3f, 2, -1, 0, 1e-3f, 5, 7, -2, 0.1f);

// Three for each triangle: many sizes, and what has no direction or is no number.
std::vector<Vec3> someVectors() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  std::vector<Vec3> vectors{Vec3(0),         Vec3(0, -0.0f, 0), Vec3(kInfinity, 0, 1),
                            Vec3(NAN, 0, 1), Vec3(1e30f, 1, 0), Vec3(1e-30f, 0, 0),
                            Vec3(3e38f)};
  while (vectors.size() < 3 * TriangleColumns::kMost) {
    const float size = std::pow(10.0f, 12 * coordinate(random));
    vectors.push_back(size * Vec3(coordinate(random), coordinate(random), coordinate(random)));
  }
  return vectors;
}

// Needles, small and large ones, some without an area, far from the origin, or too large for float.
std::vector<Vec3> someTriangles() {
  std::vector<Vec3> corners = someVectors();
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const float size = std::pow(10.0f, static_cast<float>(i % 17) - 8), place = i % 4 == 1 ? 100 * size : 0;
    if (i % 2 == 0) corners[i + 1] = corners[i] + Vec3(size, place, 0);
    if (i % 5 == 0) corners[i + 2] = corners[i] + Vec3(0.5f * size, i % 10 == 0 ? 1e-3f * size : size, place);
    if (i % 11 == 0) corners[i + 2] = 0.5f * (corners[i] + corners[i + 1]);
  }
  corners[30] = corners[31] = corners[32];
  corners[33] = Vec3(2e38f, 0, 0), corners[34] = Vec3(2e38f, 1, 0), corners[35] = Vec3(2e38f, 0, 1);
  corners[36] = Vec3(0), corners[37] = Vec3(3e19f, 0, 0), corners[38] = Vec3(0, 3e19f, 0);
  return corners;
}

void put(const Vec3 &v, size_t i, Columns &columns) {
  for (int axis = 0; axis < 3; ++axis) columns[axis][i] = v[axis];
}
Vec3 at(const Columns &columns, size_t i) { return {columns[0][i], columns[1][i], columns[2][i]}; }

// Equal bits, but one NaN is as good as another.
bool same(float expected, float got) {
  if (std::isnan(expected) || std::isnan(got)) return std::isnan(expected) && std::isnan(got);
  return std::bit_cast<uint32_t>(got) == std::bit_cast<uint32_t>(expected);
}
bool same(const Vec3 &expected, const Vec3 &got) {
  return same(expected.x, got.x) && same(expected.y, got.y) && same(expected.z, got.z);
}

// check(columns, count, name of the instruction set), for columns with these corners and normals.
template <class Check>
void onEveryTarget(const std::vector<Vec3> &corners, const std::vector<Vec3> &normals, Check &&check) {
  int targets = 0;
  forEachTarget([&](const char *name) {
    for (const size_t count : {size_t(1), size_t(5), size_t(17), TriangleColumns::kMost}) {
      const auto columns = std::make_unique<TriangleColumns>();
      for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < 3; ++k) put(corners[3 * i + k], i, columns->position[k]);
        for (size_t k = 0; k < 3; ++k) put(normals[3 * i + k], i, columns->normal[k]);
      }
      check(*columns, count, name);
    }
    ++targets;
  });
  EXPECT_GT(targets, 0);
}

TEST(VertexStage, TransformsAsGlmDoes) {
  const std::vector<Vec3> vectors = someVectors();
  onEveryTarget(vectors, vectors, [&](TriangleColumns &columns, size_t count, const char *name) {
    ddk::transformPositions(kMatrix, count, columns);
    ddk::transformNormals(kNormalMatrix, count, columns);
    for (size_t i = 0; i < 3 * count; ++i) {
      const Vec3 position(kMatrix * Vec4(vectors[i], 1)), normal = normalizedOr(kNormalMatrix * vectors[i], Vec3(0));
      EXPECT_TRUE(same(position, at(columns.position[i % 3], i / 3))) << name << ' ' << i;
      EXPECT_TRUE(same(normal, at(columns.normal[i % 3], i / 3))) << name << ' ' << i;
    }
  });
}

TEST(VertexStage, PlanesAreThoseOfTheScalarFunction) {
  const std::vector<Vec3> corners = someTriangles();
  size_t usable = 0, slivers = 0, areaBeyondFloat = 0, nowhere = 0, withoutArea = 0;
  onEveryTarget(corners, corners, [&](TriangleColumns &columns, size_t count, const char *name) {
    ddk::setPlanes(count, columns);
    for (size_t i = 0; i < count; ++i) {
      const Vec3 &a = corners[3 * i], &b = corners[3 * i + 1], &c = corners[3 * i + 2];
      const hal::TrianglePlane plane = hal::planeOf(a, b, c);
      const float area = columns.doubleArea[i];
      if (!isFinite(a + b + c) || !std::isfinite(plane.doubleArea)) {
        EXPECT_FALSE(std::isfinite(area)) << name << ' ' << i;
        ++(isFinite(a + b + c) ? areaBeyondFloat : nowhere);
        continue;
      }
      EXPECT_TRUE(same(plane.doubleArea, area)) << name << ' ' << i << ": " << plane.doubleArea << ' ' << area;
      withoutArea += area == 0;
      if (area == 0) continue;
      EXPECT_TRUE(same(plane.flatNormal, at(columns.flatNormal, i))) << name << ' ' << i;
      EXPECT_TRUE(same(plane.safeOffset, columns.safeOffset[i])) << name << ' ' << i;
      ++usable;
      slivers += plane.safeOffset > hal::kPositionError * hal::largestCoordinate(a, b, c);
    }
  });
  for (const size_t kind : {usable, slivers, areaBeyondFloat, nowhere, withoutArea}) EXPECT_GT(kind, 0u);
}

// Triangle i has the normals of corners whose bits in i are set.
TEST(VertexStage, CornersWithoutANormalGetTheFront) {
  std::vector<Vec3> corners, normals;
  for (size_t i = 0; i < TriangleColumns::kMost; ++i) {
    for (const Vec3 &corner : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) corners.push_back(corner);
    for (size_t k = 0; k < 3; ++k) normals.push_back(i >> k & 1 ? Vec3(1, 0, float(i)) : Vec3(0, -0.0f, 0));
  }
  onEveryTarget(corners, normals, [&](TriangleColumns &columns, size_t count, const char *name) {
    for (const bool clockwise : {false, true}) {
      for (size_t i = 0; i < 3 * count; ++i) put(normals[i], i / 3, columns.normal[i % 3]);
      ddk::setPlanes(count, columns);
      ddk::completeNormals(clockwise, count, columns);
      for (size_t i = 0; i < 3 * count; ++i) {
        const bool own = i / 3 >> i % 3 & 1;
        const Vec3 front(0, 0, clockwise ? -1 : 1), got = at(columns.normal[i % 3], i / 3);
        EXPECT_EQ(got, own ? normals[i] : front) << name << ' ' << i;
        EXPECT_EQ(columns.hasNormals[i / 3], i / 3 % 8 ? uint32_t{hal::kHasNormals} : 0u) << name << ' ' << i;
      }
    }
  });
}

}  // namespace
}  // namespace rc::test
