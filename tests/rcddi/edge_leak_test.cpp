// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// No ray passes between triangles that have an edge or a vertex in common: on each structure and instruction set, for
// meshes that are bent, needle-thin, far from the origin, tiny and huge.
#include "common/edge_rays.h"
#include "common/on_each_target.h"

namespace rc::test {
namespace {

Triangles moved(Triangles triangles, float scale, const Vec3 &by) {
  for (hal::HotTriangle &t : triangles) {
    for (Vec3 *v : {&t.v0, &t.v1, &t.v2}) *v = *v * scale + by;
  }
  return triangles;
}

// Cells a thousand times longer than wide, in a fan.
Triangles needles() {
  return gridSurface(24, [](float u, float v) { return Vec3(u * 0.02f, 0.3f * std::sin(2 * v), 10 * v + 0.01f * u); });
}
Triangles steps() {
  return gridSurface(16, [](float u, float v) { return Vec3(std::floor(u * 8) / 8, std::floor(v * 8) / 8, u + v); });
}
Triangles plane() {
  return gridSurface(16, [](float u, float v) { return Vec3(u, 0, v); });
}

struct Mesh {
  const char *name;
  Triangles (*make)();
};
const Mesh kMeshes[] = {
    {"Knot", [] { return knot(40); }},
    {"Terrain", [] { return terrain(30); }},
    {"Needles", needles},
    {"Plane", plane},
    {"Steps", steps},
    {"Far",
     [] {
       return moved(terrain(12), 10, {1e5f, -1e5f, 1e5f});
     }},
    {"Tiny", [] { return moved(knot(20), 1e-6f, {}); }},
    {"Huge", [] { return moved(knot(20), 1e6f, {}); }},
};

class EdgeLeaks : public testing::TestWithParam<Mesh> {
 protected:
  static constexpr size_t kRays = 4096;

  void SetUp() override {
    mTriangles = GetParam().make();
    mRays = EdgeRays(mTriangles, 5).some(kRays);
    ASSERT_GT(mRays.size(), kRays / 2) << "hardly anything to aim at";
    for (const EdgeRays::AimedRay &aimed : mRays) mPlain.push_back(aimed.ray);
  }

  size_t leaks(std::span<const hal::Hit> hits) const {
    size_t count = 0;
    for (size_t i = 0; i < hits.size(); ++i) count += !EdgeRays::stopped(mRays[i], hits[i]);
    return count;
  }

  void expectNone(TestScene &scene) const {
    const hal::SceneView &view = scene.update();
    std::vector<hal::Hit> hits(mRays.size());
    hal::createDevice("cpu", 1)->intersect(view, mPlain, hits);
    EXPECT_EQ(leaks(hits), 0u);
    const Columns columns(mPlain);
    onEachTarget([&] { EXPECT_EQ(leaks(closestHits(view, columns)), 0u); });
  }

  Triangles mTriangles;
  std::vector<EdgeRays::AimedRay> mRays;
  std::vector<hal::Ray> mPlain;
};

TEST_P(EdgeLeaks, Bvh) {
  TestScene scene(mTriangles);
  expectNone(scene);
}
TEST_P(EdgeLeaks, KdTree) {
  TestScene scene(mTriangles, AccelKind::KdTree);
  expectNone(scene);
}
TEST_P(EdgeLeaks, NoStructure) {
  TestScene scene(mTriangles, AccelKind::Exhaustive);
  std::vector<hal::Hit> hits(mRays.size());
  hal::createDevice("ref", 1)->intersect(scene.update(), mPlain, hits);
  EXPECT_EQ(leaks(hits), 0u);
}
TEST_P(EdgeLeaks, FittedTree) {
  TestScene scene(mTriangles);
  Triangles bent = mTriangles;
  const float size = maxComponent(scene.accel.bounds.size());
  for (hal::HotTriangle &t : bent) {
    for (Vec3 *v : {&t.v0, &t.v1, &t.v2}) v->y += 0.1f * size * std::sin(3 * v->x / size);
  }
  scene.accel = ddk::buildAccel(AccelKind::Bvh, bent, Workers(2));
  ddk::refit(mTriangles, Workers(2), scene.accel);
  expectNone(scene);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EdgeLeaks, testing::ValuesIn(kMeshes),
                         [](const auto &mesh) { return std::string(mesh.param.name); });

}  // namespace
}  // namespace rc::test
