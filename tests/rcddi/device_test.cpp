// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Devices against the oracle: every device gives ref's hits and ref's pictures, on any number of threads.
#include <gtest/gtest.h>

#include "common/meshes.h"

namespace rc::test {
namespace {

using namespace rc::hal;

TEST(Registry, DevicesByName) {
  for (const char *name : {"cpu", "ref", "null"}) {
    const auto device = createDevice(name, 1);
    ASSERT_TRUE(device) << name;
    EXPECT_EQ(device->name(), name);
  }
  EXPECT_FALSE(createDevice("fpga", 1));
}

// Glass, mirror and plain surfaces with two lights: every kind of ray.
class Devices : public testing::Test {
 protected:
  static constexpr int kWidth = 96, kHeight = 64;

  void build(TestScene &scene) {
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
      scene.triangles[i].material = uint32_t(1 + i / 37 % 3);
      if (i % 5 == 0) scene.triangles[i].flags |= kTransmittanceShadow;
    }
    scene.materials[1].ambient = {0.1f, 0.1f, 0.2f};
    scene.materials[2].reflection = Rgb(0.6f);
    scene.materials[3].transmittance = {0.3f, 0.5f, 0.6f};
    scene.materials[3].refractionIndex = 1.3f;
    scene.materials[3].shadowTint = {0.3f, 0.5f, 0.6f};
    LightRow point, sun;
    point.directional = false;
    point.position = {1, 3, 2};
    point.diffuse = {0.7f, 0.6f, 0.5f};
    point.specular = Rgb(0.3f);
    sun.position = glm::normalize(Vec3(-1, 1, 1));
    sun.ambient = Rgb(0.1f);
    sun.diffuse = Rgb(0.4f);
    scene.lights = {point, sun};
    scene.view.camera.eye = {0.1f, 0.2f, 4};
    scene.view.camera.columns = kWidth;
    scene.view.camera.rows = kHeight;
    scene.view.clearColor = {0.2f, 0.3f, 0.4f};
    scene.view.maxBounces = 5;
  }

  std::vector<uint32_t> picture(const char *device, int threads, AccelKind kind, const Triangles &triangles,
                                int samples = 1) {
    TestScene scene(triangles, kind);
    build(scene);
    scene.view.samples = samples;
    std::vector<uint32_t> pixels(kWidth * kHeight);
    mCounts = createDevice(device, threads)->trace(scene.update(), {pixels.data(), kWidth, kHeight});
    return pixels;
  }

  RayCounts mCounts;
};

TEST_F(Devices, CpuAgreesWithRef) {
  for (const Triangles &triangles : {knot(16), soup(300, 21), terrain(12)}) {
    const std::vector<uint32_t> truth = picture("ref", 1, AccelKind::Exhaustive, triangles);
    const RayCounts counts = mCounts;
    for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh}) {
      const std::vector<uint32_t> found = picture("cpu", 2, kind, triangles);
      EXPECT_EQ(mCounts.all(), counts.all());
      for (size_t i = 0; i < truth.size(); ++i) {
        for (int shift = 0; shift < 24; shift += 8) {
          ASSERT_NEAR(double(found[i] >> shift & 255), double(truth[i] >> shift & 255), 1) << "pixel " << i;
        }
      }
    }
    EXPECT_GT(counts.reflected, 0u);
    EXPECT_GT(counts.refracted, 0u);
    EXPECT_GT(counts.shadow, 0u);
  }
}

TEST_F(Devices, ThePictureDoesNotDependOnTheThreads) {
  const Triangles triangles = knot(24);
  for (int samples : {1, 3}) {
    const std::vector<uint32_t> one = picture("cpu", 1, AccelKind::KdTree, triangles, samples);
    EXPECT_EQ(one, picture("cpu", 2, AccelKind::KdTree, triangles, samples));
    EXPECT_EQ(one, picture("cpu", 7, AccelKind::KdTree, triangles, samples));
  }
}

TEST_F(Devices, NullGivesTheClearColour) {
  for (uint32_t pixel : picture("null", 1, AccelKind::Bvh, knot(4))) ASSERT_EQ(pixel, 0xff664c33u);
}

TEST_F(Devices, RefIntersectsLikeCpu) {
  TestScene scene(soup(200, 4), AccelKind::KdTree);
  const std::vector<Ray> rays = randomRays(20000, 5);
  std::vector<Hit> truth(rays.size()), found(rays.size());
  createDevice("ref", 1)->intersect(scene.update(), rays, truth);
  createDevice("cpu", 2)->intersect(scene.update(), rays, found);
  for (size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(found[i].primitive, truth[i].primitive);
    ASSERT_EQ(found[i].t, truth[i].t);
  }
}

}  // namespace
}  // namespace rc::test
