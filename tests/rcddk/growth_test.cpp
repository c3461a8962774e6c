// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Structures of hard soups grow with the number of triangles and no faster, in bytes and in depth, and give the hits
// that trying all triangles gives.
#include "common/hard_soups.h"
#include "common/hits.h"

namespace rc::test {
namespace {

class Growth : public testing::TestWithParam<HardSoup> {
 protected:
  static ddk::Accel build(AccelKind kind, ddk::Lifetime lifetime, size_t count) {
    return ddk::buildAccel(kind, makeSoup(GetParam(), count), Workers(2), lifetime);
  }
};

TEST_P(Growth, BytesAreInProportionToTriangles) {
  constexpr size_t kFew = 10000, kMany = 80000;
  for (const auto &[kind, lifetime] : {std::pair{AccelKind::KdTree, ddk::Lifetime::Scene},
                                       {AccelKind::Bvh, ddk::Lifetime::Scene},
                                       {AccelKind::Bvh, ddk::Lifetime::Frame}}) {
    const double few = double(build(kind, lifetime, kFew).bytes()) / kFew;
    const double many = double(build(kind, lifetime, kMany).bytes()) / kMany;
    EXPECT_LE(many, 1.5 * few + 8) << int(kind);
    EXPECT_LE(many, 300) << int(kind);  // bytes a triangle
  }
}

TEST_P(Growth, HitsAreRight) {
  const Triangles triangles = makeSoup(GetParam(), 300);
  const std::vector<hal::Ray> rays = randomRays(600, 3);
  const auto truth = hitsWith(AccelKind::Exhaustive, triangles, rays);
  expectSame(hitsWith(AccelKind::KdTree, triangles, rays), truth, "kd-tree");
  expectSame(hitsWith(AccelKind::Bvh, triangles, rays), truth, "BVH");
}

INSTANTIATE_TEST_SUITE_P(Soups, Growth, testing::ValuesIn(kHardSoups),
                         [](const auto &soup) { return std::string(soup.param.name); });

}  // namespace
}  // namespace rc::test
