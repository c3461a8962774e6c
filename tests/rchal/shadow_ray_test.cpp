// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rchal/units/shadow_ray.h"

#include <gtest/gtest.h>

namespace rc::test {
namespace {

using namespace rc::hal;

LightRow pointLight(const Vec3 &position) {
  LightRow light;
  light.directional = false;
  light.position = position;
  return light;
}

// What lights shine on: 4 wide at most.
const Bounds kScene{{-1, 0, -2}, {1, 1, 2}};

TEST(ShadowRays, StartAtLightsThatAreNotFarOff) {
  for (const Vec3 &near : {Vec3(0, 0.5f, 0), Vec3(0, 3, 0), Vec3(65, 0, 0), Vec3(-65, -64, -66)}) {
    EXPECT_TRUE(sendsShadowRays(pointLight(near), kScene)) << near.x;
  }
  for (const Vec3 &far : {Vec3(65.1f, 0, 0), Vec3(0, -65, 0), Vec3(0, 0, 1e6f), Vec3(kInfinity, 0, 0)}) {
    EXPECT_FALSE(sendsShadowRays(pointLight(far), kScene)) << far.x;
  }
  EXPECT_FALSE(sendsShadowRays(pointLight(Vec3(std::nanf(""))), kScene));
}

TEST(ShadowRays, StartAtNoDirectionalLightAndWhereThereIsNothing) {
  LightRow light = pointLight({0, 1, 0});
  EXPECT_FALSE(sendsShadowRays(light, {}));
  light.directional = true;
  EXPECT_FALSE(sendsShadowRays(light, kScene));
}

class ShadowRay : public testing::Test {
 protected:
  void makeTerm(const Vec3 &position) {
    mLight = pointLight(position);
    mTerm.towards = position - mPoint.position;
    mTerm.distance = glm::length(mTerm.towards);
    mTerm.direction = glm::normalize(mTerm.towards);
  }
  Vec3 at(float t) const {
    const Ray ray = shadowRay(mLight, mPoint, mTerm);
    return ray.origin + t * ray.direction;
  }
  void expectAt(float t, const Vec3 &place) const {
    for (int axis = 0; axis < 3; ++axis) EXPECT_FLOAT_EQ(at(t)[axis], place[axis]) << "axis " << axis;
  }

  SurfacePoint mPoint{
      .position = {1, 2, 3}, .flatNormal = {0, 1, 0}, .normal = {0, 1, 0}, .safeOffset = 0.25f, .front = true};
  LightRow mLight;
  LightTerm mTerm;
};

TEST_F(ShadowRay, OfAFarLightGoesFromOffTheSurface) {
  makeTerm({1, 102, 3});
  expectAt(0, {1, 2.25f, 3});
  expectAt(1, {1, 102.25f, 3});
  const Reach reach = reachOf(mLight);
  EXPECT_EQ(reach.begin, 0);
  EXPECT_EQ(reach.end, 1 - kAtLight);
  EXPECT_EQ(reach.towardsLight({0, 2, 0}), Vec3(0, 2, 0));
}

TEST_F(ShadowRay, OfANearLightComesFromItAndEndsOffTheSurface) {
  makeTerm({4, 6, 3});
  mLight.sendsShadowRays = true;
  EXPECT_EQ(at(0), mLight.position);
  expectAt(1, {1, 2.25f, 3});
  const Reach reach = reachOf(mLight);
  EXPECT_EQ(reach.begin, kAtLight);
  EXPECT_EQ(reach.end, 1);
  EXPECT_EQ(reach.towardsLight({0, 2, 0}), Vec3(0, -2, 0));
}

TEST_F(ShadowRay, EndsOnTheSideOfTheLight) {
  makeTerm({1, -2, 3});
  mLight.sendsShadowRays = true;
  expectAt(1, {1, 1.75f, 3});
}

TEST_F(ShadowRay, EndsFartherOffIfItIsLong) {
  mPoint.safeOffset = 1e-9f;
  EXPECT_EQ(endOffset(mPoint, 1000), 1000 * kPositionError);
  EXPECT_EQ(endOffset(mPoint, 1e-6f), mPoint.safeOffset);
}

TEST_F(ShadowRay, OfADirectionalLightHasNoEnd) {
  mLight.position = mTerm.towards = mTerm.direction = {0, 1, 0};
  mTerm.distance = kInfinity;
  expectAt(3, {1, 5.25f, 3});
  EXPECT_EQ(reachOf(mLight).end, kInfinity);
}

}  // namespace
}  // namespace rc::test
