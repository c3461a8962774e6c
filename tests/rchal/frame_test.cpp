// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Whole frames of small scenes whose pixels can be calculated: mirrors, glass, shadows, transparency, limits.
#include <gtest/gtest.h>

#include "common/meshes.h"
#include "rchal/units/tolerance.h"

namespace rc::test {
namespace {

using namespace rc::hal;

enum : uint32_t { kGround = 1, kPane = 2, kBehind = 3 };

// The viewer stands at (0, 0, 5) and looks along -z through a window of one pixel, at whose corner the view lies.
class Frame : public testing::Test {
 protected:
  Triangles mTriangles;

  void addSquare(float z, uint32_t material, uint32_t flags = 0, float size = 10) {
    const Vec3 a(-size, -size, z), b(size, -size, z), c(size, size, z), d(-size, size, z);
    mTriangles.push_back(triangle(a, b, c, material, flags));
    mTriangles.push_back(triangle(a, c, d, material, flags));
  }

  // The colour of the ray along -z, in 1/256.
  std::array<int, 3> trace(TestScene &scene, const char *device = "cpu") {
    scene.view.camera = {.eye = {0.05f, 0.02f, 5}};
    scene.view.camera.left = scene.view.camera.bottom = 0;
    scene.view.camera.columns = scene.view.camera.rows = 1;
    if (scene.lights.empty()) scene.lights.push_back(ambientOnly());
    uint32_t pixel = 0;
    mCounts = createDevice(device, 1)->trace(scene.update(), {&pixel, 1, 1});
    return {int(pixel & 255), int(pixel >> 8 & 255), int(pixel >> 16 & 255)};
  }

  // A texture of one texel, which must outlive the scene's last frame.
  static void paintPane(TestScene &scene, const uint32_t &texel) {
    TextureView texture;
    texture.levels[0] = &texel;
    texture.width = texture.height = texture.levelCount = 1;
    scene.textures = {texture};
    scene.materials[kPane].texture = 0;
  }

  static LightRow ambientOnly() {
    LightRow light;
    light.ambient = Rgb(1);
    light.diffuse = light.specular = Rgb(0);
    return light;
  }

  // Light from above that adds so many steps of a byte to what is white.
  static LightRow overhead(float steps) {
    LightRow light;
    light.ambient = light.specular = Rgb(0);
    light.diffuse = Rgb(steps * kStep);
    return light;
  }

  RayCounts mCounts;
};

using Bytes = std::array<int, 3>;

TEST_F(Frame, MissesShowTheClearColour) {
  TestScene scene({});
  scene.view.clearColor = {0.25f, 0.5f, 0.75f};
  EXPECT_EQ(trace(scene), (Bytes{64, 128, 192}));
}

TEST_F(Frame, MirrorAndGlassAreWeighed) {
  addSquare(0, kPane);
  addSquare(-1, kBehind);
  addSquare(9, kGround);
  TestScene scene(mTriangles);
  scene.materials[kPane].ambient = {0.5f, 0, 0};
  scene.materials[kPane].reflection = Rgb(0.25f);
  scene.materials[kPane].transmittance = Rgb(0.5f);
  scene.materials[kBehind].ambient = {0, 0.5f, 0};
  scene.materials[kGround].ambient = {0, 0, 0.5f};
  EXPECT_EQ(trace(scene), (Bytes{32, 64, 32}));
  EXPECT_EQ(mCounts.reflected, 1u);
  EXPECT_EQ(mCounts.refracted, 1u);
}

TEST_F(Frame, AtTheLimitASurfaceShowsItsOwnColour) {
  addSquare(0, kPane);
  TestScene scene(mTriangles);
  scene.materials[kPane].ambient = {0.5f, 0.5f, 0.5f};
  scene.materials[kPane].reflection = Rgb(1);
  scene.view.clearColor = {0.25f, 0.25f, 0.25f};
  scene.view.maxBounces = 0;
  EXPECT_EQ(trace(scene), (Bytes{128, 128, 128}));
  scene.view.maxBounces = 1;
  EXPECT_EQ(trace(scene), (Bytes{64, 64, 64}));
}

TEST_F(Frame, TwoMirrorsBounceAsOftenAsAllowed) {
  addSquare(0, kPane);
  addSquare(9, kPane);
  TestScene scene(mTriangles);
  scene.materials[kPane].reflection = Rgb(1);
  for (int limit : {1, 5, 14}) {
    scene.view.maxBounces = limit;
    trace(scene);
    EXPECT_EQ(mCounts.reflected, uint64_t(limit));
  }
}

TEST_F(Frame, WeakRaysAreDroppedAtTheThreshold) {
  addSquare(0, kPane);
  TestScene scene(mTriangles);
  scene.materials[kPane].ambient = Rgb(0);
  scene.materials[kPane].reflection = Rgb(0.05f);
  scene.view.clearColor = Rgb(1);
  EXPECT_EQ(trace(scene)[0], 12);
  scene.view.minWeight = 0.06f;
  EXPECT_EQ(trace(scene)[0], 0);
  EXPECT_EQ(mCounts.reflected, 0u);
}

// Light that changes a pixel by less than half a step is not worth a ray, as long as all such light together changes it
// by no more than one.
TEST_F(Frame, ShadowsOfWeakLightAreNotAskedFor) {
  addSquare(0, kGround);
  addSquare(9, kPane);  // above the viewer, below the lights
  TestScene scene(mTriangles);
  scene.materials[kGround].diffuse = Rgb(1);
  const auto rays = [&](std::initializer_list<float> steps, const char *device) {
    scene.lights.clear();
    for (const float step : steps) scene.lights.push_back(overhead(step));
    trace(scene, device);
    return mCounts.shadow;
  };
  for (const char *device : {"ref", "cpu"}) {
    scene.view.ignorable = kStep;
    EXPECT_EQ(rays({0.4f}, device), 0u);
    EXPECT_EQ(rays({0.6f}, device), 1u);
    EXPECT_EQ(rays({0.4f, 0.4f, 0.4f, 0.1f}, device), 1u);  // the third would be too much, the fourth is not
    scene.view.ignorable = 0;
    EXPECT_EQ(rays({0.4f}, device), 1u);
  }
}

// What a pixel may be off by because of weak light, it cannot lack because of weak rays too.
TEST_F(Frame, WeakLightLeavesLessForWeakRays) {
  addSquare(0, kPane);
  addSquare(9, kGround);
  TestScene scene(mTriangles);
  scene.materials[kPane].diffuse = Rgb(1);
  scene.materials[kPane].reflection = Rgb(0.3f * kStep);
  scene.view.ignorable = kStep;
  for (const char *device : {"ref", "cpu"}) {
    scene.lights = {overhead(0.45f)};
    trace(scene, device);
    EXPECT_EQ(mCounts.all(), 1u);
    scene.lights.push_back(overhead(0.45f));
    trace(scene, device);
    EXPECT_EQ(mCounts.shadow, 0u);
    EXPECT_EQ(mCounts.reflected, 1u);
  }
}

// Snell: a ray at 45 degrees into index 1.5 leaves at asin(sin 45 / 1.5) = 28.1 degrees. The edge of what lies
// behind is seen where that says.
TEST_F(Frame, RefractionFollowsSnell) {
  const float bent = std::asin(std::sin(glm::radians(45.0f)) / 1.5f);
  for (const float side : {-0.01f, 0.01f}) {
    Triangles scene3{triangle({-50, 0, -50}, {-50, 0, 50}, {50, 0, 50}, kPane),
                     triangle({-50, 0, -50}, {50, 0, 50}, {50, 0, -50}, kPane)};
    const float x = 0.5f * 0 + std::tan(bent);  // where the ray meets y = -1
    scene3.push_back(triangle({x + side, -1, -50}, {x + side, -1, 50}, {50, -1, 0}, kBehind));
    TestScene scene(scene3);
    scene.materials[kPane].transmittance = Rgb(1);
    scene.materials[kPane].refractionIndex = 1.5f;
    scene.materials[kBehind].ambient = Rgb(1);
    scene.lights.push_back(ambientOnly());
    CameraView &camera = scene.view.camera;
    camera.eye = {-2, 2, 0};
    camera.back = glm::normalize(Vec3(-1, 1, 0));
    camera.right = {0, 0, -1};
    camera.up = glm::cross(camera.back, camera.right);
    camera.left = camera.bottom = 0;
    camera.columns = camera.rows = 1;
    uint32_t pixel = 0;
    createDevice("cpu", 1)->trace(scene.update(), {&pixel, 1, 1});
    EXPECT_EQ(pixel & 255, side < 0 ? 255u : 0u);
  }
}

TEST_F(Frame, TotalReflectionTakesTheMirrorDirection) {
  // From behind (the back face) at 60 degrees with index 1.5: beyond the critical angle of 41.8 degrees.
  TestScene scene({triangle({-50, 0, -50}, {50, 0, 50}, {-50, 0, 50}, kPane),
                   triangle({-50, 0, -50}, {50, 0, -50}, {50, 0, 50}, kPane),
                   triangle({20, 50, -50}, {20, 0.5f, 0}, {20, 50, 50}, kBehind)});
  scene.materials[kPane].transmittance = Rgb(1);
  scene.materials[kPane].refractionIndex = 1.5f;
  scene.materials[kBehind].ambient = Rgb(1);
  scene.lights.push_back(ambientOnly());
  CameraView &camera = scene.view.camera;
  camera.eye = {-3.4641016f, 2, 0};
  camera.back = glm::normalize(camera.eye);
  camera.right = {0, 0, -1};
  camera.up = glm::cross(camera.back, camera.right);
  camera.left = camera.bottom = 0;
  camera.columns = camera.rows = 1;
  uint32_t pixel = 0;
  const RayCounts counts = createDevice("cpu", 1)->trace(scene.update(), {&pixel, 1, 1});
  EXPECT_EQ(pixel & 255, 255u);
  EXPECT_EQ(counts.reflected, 1u);
  EXPECT_EQ(counts.refracted, 0u);
  scene.materials[kPane].reflection = scene.materials[kPane].transmittance = Rgb(0.5f);
  EXPECT_EQ(createDevice("cpu", 1)->trace(scene.update(), {&pixel, 1, 1}).reflected, 1u) << "one ray for both shares";
  EXPECT_EQ(pixel & 255, 255u);
}

// Whether shadow rays start at the light.
class Shadows : public Frame, public testing::WithParamInterface<bool> {
 protected:
  // A lit ground; the light stands at (0, 0, 3), a pane lies off the line of sight, between light and ground.
  TestScene &litScene(uint32_t paneFlags, bool pane = true) {
    addSquare(0, kGround);
    if (pane) {
      mTriangles.push_back(triangle({-9, -9, 2}, {0.04f, -9, 2}, {-9, 9, 2}, kPane, paneFlags));
      mTriangles.push_back(triangle({0.04f, -9, 2}, {0.04f, 9, 2}, {-9, 9, 2}, kPane, paneFlags));
    }
    mScene = std::make_unique<TestScene>(mTriangles);
    mScene->materials[kGround].ambient = Rgb(0.25f);
    mScene->materials[kGround].diffuse = Rgb(0.5f);
    LightRow light;
    light.directional = false;
    light.sendsShadowRays = GetParam();
    light.position = {-1, 0.02f, 3};
    light.ambient = light.diffuse = Rgb(1);
    mScene->lights = {light};
    return *mScene;
  }
  std::unique_ptr<TestScene> mScene;
};

// N.L at the point seen: the light is 1.05 to the side and 3 up.
const float kCosine = 3 / std::sqrt(9 + 1.05f * 1.05f);

int lit(float share) { return int(256 * (0.25f + 0.5f * kCosine * share)); }

TEST_P(Shadows, NothingInTheWay) { EXPECT_NEAR(trace(litScene(0, false))[0], lit(1), 1); }

TEST_P(Shadows, AmbientStaysInShadow) { EXPECT_EQ(trace(litScene(0))[0], 64); }

TEST_P(Shadows, CanBeSwitchedOff) {
  litScene(0).view.shadows = false;
  EXPECT_NEAR(trace(*mScene)[0], lit(1), 1);
  EXPECT_EQ(mCounts.shadow, 0u);
}

TEST_P(Shadows, TransparentOccludersBlockUnlessAsked) {
  litScene(0).materials[kPane].shadowTint = Rgb(0.5f);
  EXPECT_EQ(trace(*mScene)[0], 64);
}

TEST_P(Shadows, TransmittanceTintsPerChannel) {
  litScene(kTransmittanceShadow).materials[kPane].shadowTint = {1, 0.5f, 0};
  const Bytes pixel = trace(*mScene);
  EXPECT_NEAR(pixel[0], lit(1), 1);
  EXPECT_NEAR(pixel[1], lit(0.5f), 1);
  EXPECT_EQ(pixel[2], 64);
}

// In a KD-tree a triangle may lie in several leaves; it must count once.
TEST_P(Shadows, EachFilterCountsOnceInEveryStructure) {
  litScene(kTransmittanceShadow);
  for (int i = 0; i < 40; ++i) addSquare(-1 - 0.1f * float(i), kBehind, 0, 30);
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh, AccelKind::Exhaustive}) {
    TestScene scene(mTriangles, kind);
    scene.materials = mScene->materials;
    scene.materials[kPane].shadowTint = Rgb(0.5f);
    scene.lights = mScene->lights;
    EXPECT_NEAR(trace(scene)[0], lit(0.5f), 1);
  }
}

// The side that counts is the one seen from the ground.
TEST_P(Shadows, CulledSidesAreNotThere) { EXPECT_NEAR(trace(litScene(kCullBack))[0], lit(1), 1); }
TEST_P(Shadows, SidesThatAreNotCulledAre) { EXPECT_EQ(trace(litScene(kCullFront))[0], 64); }

TEST_P(Shadows, ALightOnASurfaceIsNotHiddenByIt) {
  litScene(0).lights[0].position.z = 2;
  const float cosine = 2 / std::sqrt(4 + 1.05f * 1.05f);
  EXPECT_NEAR(trace(*mScene)[0], 256 * (0.25f + 0.5f * cosine), 1);
}

// But by what is a little below it.
TEST_P(Shadows, ALightCloselyAboveASurfaceIsHidden) {
  litScene(0).lights[0].position.z = 2.001f;
  EXPECT_EQ(trace(*mScene)[0], 64);
}

INSTANTIATE_TEST_SUITE_P(FromLights, Shadows, testing::Bool());

TEST_F(Frame, TransparentTexelsLetTheRayGoStraightOn) {
  addSquare(1, kPane);
  addSquare(0, kBehind);
  TestScene scene(mTriangles);
  const uint32_t texel = 0x080000ff;  // red, alpha 8 of 16
  paintPane(scene, texel);
  scene.materials[kBehind].ambient = {0, 0.5f, 0};
  scene.view.maxBounces = 0;  // going straight on is no bounce
  const Bytes pixel = trace(scene);
  EXPECT_NEAR(pixel[0], 128, 1);
  EXPECT_NEAR(pixel[1], 64, 1);
  EXPECT_EQ(mCounts.straight, 1u);
}

TEST_F(Frame, AThousandTransparentLayersAreAllPassed) {
  for (int i = 0; i < 1000; ++i) addSquare(-0.01f * float(i), kPane);
  TestScene scene(mTriangles);
  const uint32_t texel = 0;
  paintPane(scene, texel);
  scene.view.clearColor = {0.5f, 0.25f, 0.125f};
  EXPECT_EQ(trace(scene), (Bytes{0x80, 0x40, 0x20}));
  EXPECT_EQ(mCounts.straight, 1000u);
}

// Each pane that is there in part sends a ray on and one back: their number is bounded by what they weigh.
TEST_F(Frame, PanesThatAreThereInPartAndMirrorAreBounded) {
  for (int i = 0; i < 12; ++i) addSquare(-float(i), kPane);
  TestScene scene(mTriangles);
  const uint32_t texel = 0x08ffffff;  // alpha 8 of 16
  paintPane(scene, texel);
  scene.materials[kPane].reflection = Rgb(0.3f);
  scene.view.maxBounces = 14;
  scene.view.ignorable = 0.5f / 255;
  trace(scene);
  EXPECT_LT(mCounts.straight + mCounts.reflected, 8192u);
  EXPECT_GT(mCounts.straight + mCounts.reflected, 100u);
}

// A ray that weighs nothing any more is not sent on.
TEST_F(Frame, BehindManyLayersNothingIsLeft) {
  for (int i = 0; i < 200; ++i) addSquare(-0.1f * float(i), kPane);
  TestScene scene(mTriangles);
  const uint32_t texel = 0x08ffffff;
  paintPane(scene, texel);
  scene.view.ignorable = 0.5f / 255;
  scene.view.clearColor = Rgb(1);
  trace(scene);
  EXPECT_LT(mCounts.straight, 20u);
}

TEST_F(Frame, TextureOnlyIsUnlitAndUnreflected) {
  addSquare(0, kPane, kTextureOnly);
  TestScene scene(mTriangles);
  const uint32_t texel = 0xff4080c0;
  paintPane(scene, texel);
  scene.materials[kPane].reflection = Rgb(1);
  LightRow dark = ambientOnly();
  dark.ambient = Rgb(0);
  scene.lights = {dark};
  EXPECT_EQ(trace(scene), (Bytes{0xc0, 0x80, 0x40}));
  EXPECT_EQ(mCounts.all(), 1u);
}

TEST_F(Frame, OutsideTheViewportThereIsTheClearColour) {
  addSquare(0, kGround);
  TestScene scene(mTriangles);
  scene.materials[kGround].ambient = Rgb(1);
  scene.lights.push_back(ambientOnly());
  scene.view.camera.eye = {0, 0, 5};
  scene.view.camera.columns = 2;
  scene.view.camera.rows = 3;
  scene.view.clearColor = {0.5f, 0, 0};
  std::vector<uint32_t> pixels(5 * 4, 1);
  createDevice("cpu", 1)->trace(scene.update(), {pixels.data(), 5, 4});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool inside = x < 2 && 3 - y < 3;
      EXPECT_EQ(pixels[size_t(y * 5 + x)], inside ? 0xffffffffu : 0xff000080u) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace rc::test
