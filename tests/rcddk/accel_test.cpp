// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Acceleration structures: every one gives the hit that trying all triangles gives, ties included.
#include <gtest/gtest.h>

#include <cstring>

#include "common/hits.h"
#include "rchal/units/traversal.h"

namespace rc::test {
namespace {

using namespace rc::hal;

TEST(Accel, NothingHitsNothing) {
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh, AccelKind::Exhaustive}) {
    for (const Hit &hit : hitsWith(kind, {}, randomRays(10, 1))) EXPECT_FALSE(hit.found());
  }
}

TEST(Accel, OneTriangleAndManyEqualOnes) {
  const HotTriangle t = triangle({-2, -2, 0}, {2, -2, 0}, {0, 2, 0});
  compareAll({t}, 2000);
  compareAll(Triangles(1000, t), 2000);
}

TEST(Accel, FlatGridsInTheCoordinatePlanes) {
  for (int axis = 0; axis < 3; ++axis) {
    Triangles grid = gridSurface(20, [&](float u, float v) {
      Vec3 point(0);
      point[(axis + 1) % 3] = 2 * u - 1, point[(axis + 2) % 3] = 2 * v - 1;
      return point;
    });
    compareAll(grid, 20000);
  }
}

TEST(Accel, HugeBesideTiny) {
  Triangles mixed = knot(8);
  mixed.push_back(triangle({-1e6f, -1, -1e6f}, {1e6f, -1, -1e6f}, {0, -1, 1e6f}));
  mixed.push_back(triangle({0, 0, 0}, {1e-5f, 0, 0}, {0, 1e-5f, 0}));
  compareAll(mixed, 20000);
}

// Rays that lie in split planes and box faces, along edges and through vertices.
TEST(Accel, RaysAlongGridLines) {
  const Triangles grid = gridSurface(16, [](float u, float v) { return Vec3(u, 0.25f * u, v); });
  std::vector<Ray> rays;
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 16; ++j) {
      rays.push_back({{float(i) / 16, 2, float(j) / 16}, {0, -1, 0}});
      rays.push_back({{float(i) / 16, -2, float(j) / 16}, {0, 1, 0}});
      rays.push_back({{float(i) / 16, 2, 0}, glm::normalize(Vec3(0, -2, float(j) / 16))});
    }
  }
  const std::vector<Hit> truth = hitsWith(AccelKind::Exhaustive, grid, rays);
  expectSame(hitsWith(AccelKind::KdTree, grid, rays), truth, "kd-tree");
  expectSame(hitsWith(AccelKind::Bvh, grid, rays), truth, "BVH");
}

template <class Nodes>
bool sameBytes(const Nodes &a, const Nodes &b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

TEST(Accel, TheTreeDoesNotDependOnTheThreads) {
  const Triangles triangles = terrain(100);
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh}) {
    const ddk::Accel one = ddk::buildAccel(kind, triangles, Workers(1));
    for (int threads : {2, 7}) {
      const ddk::Accel many = ddk::buildAccel(kind, triangles, Workers(threads));
      EXPECT_TRUE(sameBytes(one.kdNodes, many.kdNodes));
      EXPECT_TRUE(sameBytes(one.bvhNodes, many.bvhNodes));
      EXPECT_TRUE(sameBytes(one.blocks, many.blocks));
      EXPECT_EQ(one.primitives, many.primitives);
    }
  }
}

// Long thin triangles across everything: cutting them must not multiply them without bound.
TEST(Accel, SliversKeepTheKdTreeSmall) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  Triangles slivers;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 a(unit(random), unit(random), -1), b(unit(random), unit(random), 1);
    slivers.push_back(triangle(a, b, b + Vec3(1e-3f, 0, 0)));
  }
  const ddk::Accel accel = ddk::buildAccel(AccelKind::KdTree, slivers, Workers(2));
  EXPECT_LE(accel.primitives.size(), 9 * slivers.size());
}

// Areas beyond float must not make one leaf of everything.
TEST(Accel, FarGeometryLeavesTheTreeATree) {
  Triangles far = terrain(40);
  far.push_back(triangle({3e18f, 0, 0}, {3e18f, 3e18f, 0}, {0, 3e18f, 3e18f}));
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh}) {
    const ddk::Accel accel = ddk::buildAccel(kind, far, Workers(1));
    EXPECT_GT(accel.kdNodes.size() + 8 * accel.bvhNodes.size(), far.size() / 8);
  }
}

// Neither their extent nor its reciprocal is a float. Planes and bins are chosen all the same.
TEST(Accel, ExtentsBeyondFloatAreNoHindrance) {
  Triangles strange = terrain(8);
  for (float x : {-1e38f, 1e38f}) strange.push_back(triangle({x, 0, 0}, {x, 1, 0}, {x, 0, 1}));
  for (int i = 0; i < 20; ++i) {
    const float x = 1e-37f * float(i);
    strange.push_back(triangle({x, 5, 5}, {x, 6, 5}, {x, 5, 6}));
  }
  std::vector<Ray> rays;
  for (int i = 0; i < 100; ++i)
    rays.push_back({{0.05f + 0.09f * float(i % 10), 2, 0.05f + 0.09f * float(i / 10)}, {0, -1, 0}});
  const std::vector<Hit> truth = hitsWith(AccelKind::Exhaustive, strange, rays);
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh}) {
    EXPECT_EQ(expectSame(hitsWith(kind, strange, rays), truth, "strange"), rays.size());
  }
}

TEST(Accel, KdLeavesHoldEveryTriangleThatReachesIntoThem) {
  const Triangles triangles = soup(400, 9);
  const ddk::Accel accel = ddk::buildAccel(AccelKind::KdTree, triangles, Workers(2));
  std::vector<bool> seen(triangles.size());
  for (uint32_t primitive : accel.primitives) seen.at(primitive) = true;
  for (size_t i = 0; i < seen.size(); ++i) EXPECT_TRUE(seen[i]) << i;
}

// How often each triangle is in a leaf; those that are so once lie inside the leaf's box.
std::vector<int> timesInLeaves(const Triangles &triangles, const ddk::Accel &accel) {
  std::vector<int> times(triangles.size());
  for (const TriangleBlock4 &block : accel.blocks) {
    for (uint32_t k = 0; k < block.count(); ++k) ++times.at(block.primitive[k]);
  }
  for (const BvhNode8 &node : accel.bvhNodes) {
    for (uint32_t i = 0; i < BvhNode8::kWidth; ++i) {
      const Vec3 lower{node.planes[0][0][i], node.planes[1][0][i], node.planes[2][0][i]};
      const Vec3 upper{node.planes[0][1][i], node.planes[1][1][i], node.planes[2][1][i]};
      if (!(node.child[i] & BvhNode8::kLeaf)) continue;
      const TriangleBlock4 &block = accel.blocks.at(node.child[i] & ~BvhNode8::kLeaf);
      for (uint32_t k = 0; k < block.count(); ++k) {
        if (times[block.primitive[k]] != 1) continue;
        const HotTriangle &triangle = triangles.at(block.primitive[k]);
        for (const Vec3 &v : {triangle.v0, triangle.v1, triangle.v2}) {
          EXPECT_TRUE(glm::all(glm::lessThanEqual(lower, v)) && glm::all(glm::lessThanEqual(v, upper)));
        }
      }
    }
  }
  return times;
}

TEST(Accel, BvhLeavesOfAFrameHoldEachTriangleOnce) {
  const Triangles triangles = soup(3000, 5);
  const ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(2), ddk::Lifetime::Frame);
  for (const int times : timesInLeaves(triangles, accel)) EXPECT_EQ(times, 1);
}

TEST(Accel, BvhLeavesOfASceneHoldAllTrianglesAndAThirdMoreAtMost) {
  const Triangles triangles = soup(3000, 5);
  const ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(2));
  size_t all = 0;
  for (const int times : timesInLeaves(triangles, accel)) {
    EXPECT_GE(times, 1);
    all += size_t(times);
  }
  EXPECT_LE(all, triangles.size() * 4 / 3);
}

// Beams askew across small triangles: in one piece each, every ray near by would meet the boxes of all of them.
TEST(Accel, LongTrianglesAskewAreCut) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(-1, 1);
  Triangles mixed;
  const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = point();
    mixed.push_back(triangle(a, a + 0.02f * point(), a + 0.02f * point()));
  }
  for (int i = 0; i < 40; ++i) {
    const Vec3 shift = 0.2f * point();
    mixed.push_back(triangle(Vec3(-0.8f) + shift, Vec3(0.8f) + shift, Vec3(0.8f, 0.8f, 0.85f) + shift));
  }
  const ddk::Accel whole = ddk::buildAccel(AccelKind::Bvh, mixed, Workers(1), ddk::Lifetime::Frame);
  const ddk::Accel parts = ddk::buildAccel(AccelKind::Bvh, mixed, Workers(1), ddk::Lifetime::Scene);
  EXPECT_GT(parts.blocks.size(), whole.blocks.size());
  EXPECT_LT(parts.builtCost, 0.8 * whole.builtCost);
  compareAll(mixed, 20000);
}

TEST(FrameBvh, GivesTheSameHitsOnAnyNumberOfThreads) {
  Triangles triangles = knot(70);
  triangles.insert(triangles.end(), 100, triangles[7]);  // equal codes
  const std::vector<Ray> rays = randomRays(20000, 6);
  const std::vector<Hit> truth = hitsWith(AccelKind::Bvh, triangles, rays);
  TestScene scene(triangles);
  scene.accel = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(1), ddk::Lifetime::Frame);
  const ddk::Accel many = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(5), ddk::Lifetime::Frame);
  EXPECT_TRUE(sameBytes(scene.accel.bvhNodes, many.bvhNodes));
  EXPECT_TRUE(sameBytes(scene.accel.blocks, many.blocks));
  std::vector<Hit> hits(rays.size());
  createDevice("cpu", 2)->intersect(scene.update(), rays, hits);
  EXPECT_GT(expectSame(hits, truth, "BVH of a frame"), 1000u);
}

TEST(FrameBvh, LeavesNothingOfTheTreeBefore) {
  const Triangles triangles = knot(70), more = knot(90), few = knot(66);
  const auto build = [](const Triangles &what, ddk::Accel old) {
    return ddk::buildAccel(AccelKind::Bvh, what, Workers(2), ddk::Lifetime::Frame, std::move(old));
  };
  const ddk::Accel fresh = build(triangles, {});
  for (const Triangles *before : {&more, &few}) {
    const ddk::Accel again = build(triangles, build(*before, {}));
    EXPECT_TRUE(sameBytes(fresh.bvhNodes, again.bvhNodes));
    EXPECT_TRUE(sameBytes(fresh.blocks, again.blocks));
  }
}

// 65 triangles in one place, eight times eight and one, take a node for each eight at each corner of a lattice.
TEST(FrameBvh, MayHaveMoreNodesThanItReserves) {
  Triangles crowds;
  for (int i = 0; i < 64; ++i) {
    const Vec3 corner = Vec3(i % 4, i / 4 % 4, i / 16) / 2.0f - 0.75f;
    crowds.insert(crowds.end(), 65, triangle(corner, corner + Vec3(0.2f, 0, 0), corner + Vec3(0, 0.2f, 0.1f)));
  }
  const std::vector<Ray> rays = randomRays(2000, 8);
  TestScene scene(crowds);
  scene.accel = {};
  scene.accel.kind = AccelKind::Bvh;
  ddk::buildMorton(crowds, Workers(1), scene.accel);
  EXPECT_GT(scene.accel.bvhNodes.size(), crowds.size() / 8 + 8);
  std::vector<Hit> hits(rays.size());
  createDevice("cpu", 1)->intersect(scene.update(), rays, hits);
  EXPECT_GT(expectSame(hits, hitsWith(AccelKind::Exhaustive, crowds, rays), "BVH of a frame"), 100u);
}

// The hits in a scene whose triangles are swapped for moved ones and whose tree is fitted to them.
std::vector<Hit> hitsAfterRefit(const Triangles &before, const Triangles &after, std::span<const Ray> rays,
                                int threads) {
  TestScene scene(before);
  scene.triangles = after;
  EXPECT_TRUE(ddk::refit(scene.triangles, Workers(threads), scene.accel));
  std::vector<Hit> hits(rays.size());
  createDevice("cpu", 2)->intersect(scene.update(), rays, hits);
  return hits;
}

TEST(Refit, GivesTheHitsOfTheMovedTriangles) {
  const Triangles before = knot(24);
  Triangles after = before;
  for (HotTriangle &t : after) {
    for (Vec3 *v : {&t.v0, &t.v1, &t.v2}) *v += 0.05f * Vec3(std::sin(3 * v->y), std::cos(2 * v->z), std::sin(v->x));
  }
  const std::vector<Ray> rays = randomRays(20000, 3);
  const std::vector<Hit> truth = hitsWith(AccelKind::Exhaustive, after, rays);
  for (int threads : {1, 5}) EXPECT_GT(expectSame(hitsAfterRefit(before, after, rays, threads), truth, "refit"), 1000u);
}

TEST(Refit, LeavesWhatHasNotMovedAsItWas) {
  const Triangles triangles = terrain(40);
  const Workers workers(2);
  ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, workers);
  const ddk::Accel built = accel;
  EXPECT_TRUE(ddk::refit(triangles, workers, accel));
  EXPECT_TRUE(sameBytes(accel.bvhNodes, built.bvhNodes));
  EXPECT_TRUE(sameBytes(accel.blocks, built.blocks));
}

// Which rays go together is decided by where most triangles are, and how large.
TEST(Refit, KnowsWhereMostTrianglesAreNow) {
  const Workers workers(2);
  const Triangles before = knot(24);
  Triangles after = before;
  for (HotTriangle &t : after) {
    for (Vec3 *v : {&t.v0, &t.v1, &t.v2}) *v = 2.0f * *v + Vec3(30, 0, -5);
  }
  ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, before, workers);
  EXPECT_LT(accel.core.upper.x, 10);
  ASSERT_TRUE(ddk::refit(after, workers, accel));
  const ddk::Accel anew = ddk::buildAccel(AccelKind::Bvh, after, workers);
  EXPECT_EQ(accel.core.lower, anew.core.lower);
  EXPECT_EQ(accel.core.upper, anew.core.upper);
  EXPECT_EQ(accel.grain, anew.grain);
  EXPECT_GT(accel.core.lower.x, 20);
}

TEST(Refit, AsksForANewTreeWhereTheOldOneIsNoGood) {
  const Triangles triangles = terrain(40);
  const Workers workers(1);
  ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, workers);
  Triangles shuffled = triangles;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
  EXPECT_FALSE(ddk::refit(shuffled, workers, accel)) << "neighbours in the tree are far apart now";
  accel = ddk::buildAccel(AccelKind::Bvh, triangles, workers);
  EXPECT_FALSE(ddk::refit(std::span(triangles).first(100), workers, accel)) << "another number of triangles";
  ddk::Accel kdTree = ddk::buildAccel(AccelKind::KdTree, triangles, workers);
  EXPECT_FALSE(ddk::refit(triangles, workers, kdTree));
}

// One triangle far away makes the bounds as large as it likes.
TEST(Refit, AsksForANewTreeThoughOneTriangleFliesAway) {
  Triangles triangles = terrain(40);
  const Workers workers(1);
  ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, workers);
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(5));
  for (Vec3 *v : {&triangles[7].v0, &triangles[7].v1, &triangles[7].v2}) v->x += 1000;
  EXPECT_FALSE(ddk::refit(triangles, workers, accel));
}

TEST(FrameBvh, IsAsGoodThoughOneTriangleIsFarAway) {
  const Workers workers(2);
  Triangles triangles = terrain(60);
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(3));
  const auto cost = [&] {
    return ddk::costOf(ddk::buildAccel(AccelKind::Bvh, triangles, workers, ddk::Lifetime::Frame));
  };
  const double before = cost();
  for (Vec3 *v : {&triangles[7].v0, &triangles[7].v1, &triangles[7].v2}) v->x += 1e4f;
  EXPECT_LT(cost(), 1.3 * before);
}

// What a triangle costs in memory, in the tree and its leaves.
TEST(Accel, ABvhTakesAtMost80BytesATriangle) {
  for (const Triangles &triangles : {terrain(60), knot(40), soup(5000, 2)}) {
    const ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(2));
    EXPECT_LE(accel.bytes(), 80 * triangles.size());
  }
}

}  // namespace
}  // namespace rc::test
