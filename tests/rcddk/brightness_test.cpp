// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What bounds the light of a scene: how near its lights come to a surface, and how bright that makes it.
#include "rcddk/brightness.h"

#include <gtest/gtest.h>

#include "common/meshes.h"
#include "rcddk/nearest.h"

namespace rc::test {
namespace {

using namespace rc::hal;

// The least distance to points all over the triangle: never below the exact one, and close to it.
float nearestSample(const HotTriangle &t, const Vec3 &p) {
  constexpr int kSteps = 64;
  float best = kInfinity;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const float u = float(i) / kSteps, v = float(j) / kSteps;
      best = std::min(best, glm::length(p - (t.v0 + u * (t.v1 - t.v0) + v * (t.v2 - t.v0))));
    }
  }
  return best;
}

TEST(NearestSurface, IsTheLeastDistanceToAnyTriangle) {
  const Triangles triangles = soup(60, 5);
  TestScene scene(triangles);
  const GeometryView &geometry = scene.update().geometry[0];
  for (const Ray &ray : randomRays(100, 3)) {
    float truth = kInfinity;
    for (const HotTriangle &t : triangles) truth = std::min(truth, nearestSample(t, ray.origin));
    const float found = ddk::nearestSurface(geometry, ray.origin);
    EXPECT_LE(found, truth * 1.0001f + 1e-6f);
    EXPECT_GE(found, truth - 0.06f) << "samples lie as far apart";
  }
}

TEST(NearestSurface, FaceEdgeAndCorner) {
  TestScene scene({triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0})});
  const GeometryView &geometry = scene.update().geometry[0];
  EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {1, 1, 3}), 3);
  EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {2, -3, 4}), 5);
  EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {-2, -1, 2}), 3);
  EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {1, 1, 0}), 0);
}

TEST(NearestSurface, FarAndLargeBeyondTheSquaresOfFloat) {
  for (const float size : {1e5f, 1e10f, 1e15f}) {
    TestScene scene({triangle({-size, -size, 0}, {size, -size, 0}, {0, size, 0})});
    const GeometryView &geometry = scene.update().geometry[0];
    EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {0, 0, 1e4f * size}), 1e4f * size);
    EXPECT_FLOAT_EQ(ddk::nearestSurface(geometry, {0, -4 * size, 4 * size}), 5 * size);
  }
}

TEST(NearestSurface, NothingIsNowhereNear) {
  TestScene scene({});
  EXPECT_EQ(ddk::nearestSurface(scene.update().geometry[0], {1, 2, 3}), kInfinity);
}

TEST(NearestSurface, ThroughAKdTreeItIsTheBoxOfAll) {
  TestScene scene({triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0})}, AccelKind::KdTree);
  const GeometryView &geometry = scene.update().geometry[0];
  EXPECT_NEAR(ddk::nearestSurface(geometry, {4, 4, 3}), 3, 1e-4f);
}

class Brightness : public testing::Test {
 protected:
  // A light over a floor, two units away.
  float withLight(float constant, float linear, float quadratic) {
    TestScene scene({triangle({-9, 0, 9}, {9, 0, 9}, {0, 0, -9})});
    scene.materials = mMaterials;
    SceneView view = scene.update();
    view.globalAmbient = Rgb(0);
    LightRow light;
    light.directional = false;
    light.position = {0, 2, 0};
    light.ambient = Rgb(0);
    light.diffuse = Rgb(8);
    light.constant = constant;
    light.linear = linear;
    light.quadratic = quadratic;
    view.lights = {&light, 1};
    return ddk::brightest(view);
  }

  std::vector<MaterialRow> mMaterials{{.ambient = Rgb(0), .diffuse = Rgb(1)}};
};

TEST_F(Brightness, OfALightThatDoesNotFade) { EXPECT_FLOAT_EQ(withLight(1, 0, 0), 8); }
TEST_F(Brightness, CoefficientsOfNothingMeanNone) { EXPECT_FLOAT_EQ(withLight(0, 0, 0), 8); }
TEST_F(Brightness, OfLightsThatFadeIsThatOfTheNearestPlace) {
  EXPECT_NEAR(withLight(0, 0, 1), 8 / 4.0f, 0.01f);
  EXPECT_NEAR(withLight(0, 1, 0), 8 / 2.0f, 0.01f);
  EXPECT_NEAR(withLight(1, 0.5f, 0.25f), 8 / 3.0f, 0.01f);
}
TEST_F(Brightness, IsNotLessThanTheRoundedDistanceAllows) { EXPECT_GE(withLight(0, 0, 1), 8 / 4.0f); }
TEST_F(Brightness, IsThatOfTheBrightestMaterial) {
  mMaterials = {{.diffuse = Rgb(0.5f)}, {.diffuse = Rgb(0.25f), .emission = Rgb(1)}};
  EXPECT_FLOAT_EQ(withLight(1, 0, 0), 0.5f * 8);
  mMaterials[1].emission = Rgb(3);
  EXPECT_FLOAT_EQ(withLight(1, 0, 0), 0.25f * 8 + 3);
}
TEST_F(Brightness, TexelsMayBeBrighterThanTheirMaterial) {
  mMaterials = {{.diffuse = Rgb(0.5f), .texture = 0}};
  EXPECT_FLOAT_EQ(withLight(1, 0, 0), 8);
}
TEST_F(Brightness, OfMirrorsThatNobodySeesIsThatOfTheBackground) {
  mMaterials = {};
  EXPECT_FLOAT_EQ(withLight(1, 0, 0), 1);
}

TEST_F(Brightness, NothingBoundsLightsThatGrow) { EXPECT_EQ(withLight(1, -1, 0), kInfinity); }

}  // namespace
}  // namespace rc::test
