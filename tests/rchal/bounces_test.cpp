// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Rooms of mirrors and glass with as many bounces as there can be: rays end by their weight, not by their number.
#include <gtest/gtest.h>

#include "common/meshes.h"
#include "rcddk/brightness.h"

namespace rc::test {
namespace {

using namespace rc::hal;

constexpr int kSide = 6, kMostBounces = 31;

// Six walls, seen from inside.
Triangles room() {
  Triangles walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto corner = [&](float u, float v) {
        Vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        return p;
      };
      walls.push_back(triangle(corner(-1, -1), corner(1, -1), corner(1, 1)));
      walls.push_back(triangle(corner(-1, -1), corner(1, 1), corner(-1, 1)));
    }
  }
  return walls;
}

RayCounts countsOf(float reflection, float transmittance, const char *device) {
  Triangles triangles = room();
  for (HotTriangle &t : room()) {  // a smaller room of glass within
    for (Vec3 *v : {&t.v0, &t.v1, &t.v2}) *v *= 0.3f;
    triangles.push_back(t);
  }
  TestScene scene(triangles);
  scene.materials[0].reflection = Rgb(reflection);
  scene.materials[0].transmittance = Rgb(transmittance);
  scene.materials[0].refractionIndex = 1.3f;
  scene.lights = {LightRow{}};
  SceneView view = scene.update();
  view.camera = {.eye = {0.1f, 0.2f, 0.9f}, .columns = kSide, .rows = kSide};
  view.maxBounces = kMostBounces;
  view.ignorable = ddk::ignorable(view);
  std::vector<uint32_t> pixels(size_t(kSide) * kSide);
  return createDevice(device, 1)->trace(view, {pixels.data(), kSide, kSide});
}

TEST(Bounces, PerfectMirrorsMakeOneRayABounce) {
  const RayCounts counts = countsOf(1, 0, "cpu");
  EXPECT_LE(counts.reflected, uint64_t(kSide * kSide * kMostBounces));
  EXPECT_GT(counts.reflected, uint64_t(kSide * kSide * kMostBounces) * 9 / 10);
}

// Two rays a bounce would be 2^31 for each pixel: after twelve bounces 4096 share its light.
TEST(Bounces, HalvesEndByTheirWeight) {
  EXPECT_LT(countsOf(0.5f, 0.5f, "cpu").all(), uint64_t(kSide * kSide) * 2 * (8192 + (kMostBounces - 12) * 4096));
  EXPECT_LT(countsOf(0.3f, 0.3f, "cpu").all(), uint64_t(kSide * kSide) * 2000);
}

TEST(Bounces, BothDevicesTraceTheSameRays) {
  EXPECT_EQ(countsOf(0.4f, 0.5f, "cpu").all(), countsOf(0.4f, 0.5f, "ref").all());
}

}  // namespace
}  // namespace rc::test
