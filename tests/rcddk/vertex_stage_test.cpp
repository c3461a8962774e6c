// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Vertices side by side come out as GLM transforms them one by one, to the last bit, on every instruction set.
#include "rcddk/vertex_stage.h"

#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <random>
#include <vector>

#include "common/ray_columns.h"

namespace rc::test {
namespace {

using ddk::VertexColumns;

const Mat4 kMatrix = glm::rotate(glm::translate(Mat4(1), Vec3(3, -0.1f, 1e4f)), 0.7f, Vec3(1, 2, 3));
const glm::mat3 kNormalMatrix(0.3f, 2, -1, 0, 1e-3f, 5, 7, -2, 0.1f);

// Many sizes, and what has no direction or is no number.
std::vector<Vec3> someVectors() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  std::vector<Vec3> vectors{Vec3(0),         Vec3(0, -0.0f, 0), Vec3(kInfinity, 0, 1),
                            Vec3(NAN, 0, 1), Vec3(1e30f, 1, 0), Vec3(1e-30f, 0, 0),
                            Vec3(3e38f)};
  while (vectors.size() < VertexColumns::kMost) {
    const float size = std::pow(10.0f, 12 * coordinate(random));
    vectors.push_back(size * Vec3(coordinate(random), coordinate(random), coordinate(random)));
  }
  return vectors;
}

void put(const Vec3 &v, size_t i, float (&columns)[3][VertexColumns::kRoom]) {
  for (int axis = 0; axis < 3; ++axis) columns[axis][i] = v[axis];
}

// Equal bits, but one NaN is as good as another.
bool same(const Vec3 &expected, size_t i, const float (&columns)[3][VertexColumns::kRoom]) {
  for (int axis = 0; axis < 3; ++axis) {
    const float got = columns[axis][i];
    if (std::isnan(expected[axis]) != std::isnan(got)) return false;
    if (!std::isnan(got) && std::bit_cast<uint32_t>(got) != std::bit_cast<uint32_t>(expected[axis])) return false;
  }
  return true;
}

TEST(VertexStage, IsWhatGlmDoes) {
  const std::vector<Vec3> vectors = someVectors();
  int targets = 0;
  forEachTarget([&](const char *name) {
    for (const size_t count : {size_t(1), size_t(5), size_t(17), vectors.size()}) {
      const auto vertices = std::make_unique<VertexColumns>();
      for (size_t i = 0; i < vectors.size(); ++i) {
        put(vectors[i], i, vertices->position);
        put(vectors[i], i, vertices->normal);
      }
      ddk::transformPositions(kMatrix, count, *vertices);
      ddk::transformNormals(kNormalMatrix, count, *vertices);
      for (size_t i = 0; i < count; ++i) {
        EXPECT_TRUE(same(Vec3(kMatrix * Vec4(vectors[i], 1)), i, vertices->position)) << name << ' ' << i;
        EXPECT_TRUE(same(normalizedOr(kNormalMatrix * vectors[i], Vec3(0)), i, vertices->normal)) << name << ' ' << i;
      }
    }
    ++targets;
  });
  EXPECT_GT(targets, 0);
}

}  // namespace
}  // namespace rc::test
