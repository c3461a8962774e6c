// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// No ray leaves a closed surface: rays from inside a sphere, aimed at its edges and vertices, hit it on each
// instruction set. RAYCORE_TEST_RAYS makes the slow version of it as long as one likes.
#include "common/on_each_target.h"
#include "common/ray_kinds.h"

namespace rc::test {
namespace {

constexpr float kTurn = 6.2831853f;

// Closed to the last bit: the seam and the poles have one place each.
Triangles sphere(int n) {
  return gridSurface(n, [](float u, float v) {
    if (v <= 0 || v >= 1) return Vec3(0, v <= 0 ? 1 : -1, 0);
    const float turn = u >= 1 ? 0 : kTurn * u, height = 0.5f * kTurn * v;
    return Vec3(std::sin(height) * std::cos(turn), std::cos(height), std::sin(height) * std::sin(turn));
  });
}

std::vector<hal::Ray> raysAtEdges(const hal::SceneView &scene, size_t count, uint32_t seed) {
  Targets targets(scene, seed);
  std::vector<hal::Ray> rays;
  Vec3 origin(0);
  for (size_t i = 0; i < count; ++i) {
    if (i % 256 == 0) origin = 0.5f * targets.unit() * targets.direction();  // tiles have a common origin
    if (i / 256 % 2) origin = 0.5f * targets.unit() * targets.direction();   // others do not
    rays.push_back({origin, normalizedOr(targets.onEdge(targets.triangle()) - origin, {0, 0, 1})});
  }
  return rays;
}

class Leaks : public testing::TestWithParam<AccelKind> {};

TEST_P(Leaks, NoRayPassesBetweenTriangles) {
  constexpr size_t kPart = 16384;
  const size_t parts = 10 * raysFromEnvironment(1000) / kPart + 1;
  TestScene scene(sphere(24), GetParam());
  const hal::SceneView view = scene.update();
  for (size_t part = 0; part < parts; ++part) {
    const Columns columns(raysAtEdges(view, kPart, uint32_t(part)));
    onEachTarget([&] {
      const std::vector<hal::Hit> hits = closestHits(view, columns);
      EXPECT_EQ(std::count_if(hits.begin(), hits.end(), [](const hal::Hit &hit) { return !hit.found(); }), 0);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(BothStructures, Leaks, testing::Values(AccelKind::Bvh, AccelKind::KdTree),
                         [](const auto &kind) { return nameOf(kind.param); });

}  // namespace
}  // namespace rc::test
