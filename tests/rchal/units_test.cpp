// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The units of the renderer by themselves, against what can be calculated by hand.
#include <gtest/gtest.h>

#include "common/meshes.h"
#include "rchal/framebuffer.h"
#include "rchal/units/lighting.h"
#include "rchal/units/ray_generation.h"
#include "rchal/units/texture.h"
#include "rchal/units/traversal.h"

namespace rc::test {
namespace {

using namespace rc::hal;

TEST(RayGeneration, ASinglesSampleLiesAtTheLowerLeftCorner) {
  CameraView camera;
  camera.columns = 4;
  camera.rows = 2;
  EXPECT_EQ(sampleOf(0, 1).place, Vec2(0, 0));
  const Vec3 corner = primaryRay(camera, 0, 0, {}).ray.direction;
  EXPECT_NEAR(corner.x / -corner.z, -1, 1e-6);
  EXPECT_NEAR(corner.y / -corner.z, -1, 1e-6);
  const Vec3 centre = primaryRay(camera, 2, 1, {}).ray.direction;
  EXPECT_NEAR(centre.x, 0, 1e-6);
  EXPECT_NEAR(centre.z, -1, 1e-6);
}

TEST(RayGeneration, SeveralSamplesFillTheSquare) {
  for (int samples : {4, 16, 64}) {
    std::vector<bool> strip(static_cast<size_t>(samples));
    double meanY = 0;
    for (int i = 0; i < samples; ++i) {
      const Vec2 p = sampleOf(i, samples).place;
      ASSERT_GE(minComponent(Vec3(p, 0)), 0);
      ASSERT_LT(maxComponent(Vec3(p, 0)), 1);
      strip.at(size_t(p.x * float(samples))) = true;
      meanY += p.y / samples;
    }
    for (bool used : strip) EXPECT_TRUE(used);
    EXPECT_NEAR(meanY, 0.5, 0.12);
  }
}

TEST(Intersection, DistanceAndWeights) {
  const HotTriangle t = triangle({0, 0, -5}, {2, 0, -5}, {0, 2, -5});
  Hit hit;
  ASSERT_TRUE(intersectTriangle(ShearedRay({{0.5f, 0.25f, 0}, {0, 0, -1}}), t, hit));
  EXPECT_FLOAT_EQ(hit.t, 5);
  EXPECT_FLOAT_EQ(hit.u, 0.25f);
  EXPECT_FLOAT_EQ(hit.v, 0.125f);
  EXPECT_FALSE(intersectTriangle(ShearedRay({{1.5f, 1.5f, 0}, {0, 0, -1}}), t, hit));
  EXPECT_FALSE(intersectTriangle(ShearedRay({{0.5f, 0.25f, 0}, {1, 0, 0}}), t, hit)) << "parallel to the plane";
}

// A fan of triangles round a vertex: no ray may slip through between two of them.
TEST(Intersection, IsWatertight) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(-1, 1);
  const int corners = 17;
  std::vector<Vec3> ring;
  for (int i = 0; i < corners; ++i) {
    const float a = 6.2831853f * float(i) / corners;
    ring.push_back({3 * std::cos(a), 3 * std::sin(a), unit(random) * 0.1f});
  }
  const Vec3 hub(0.0123f, -0.0456f, 0.05f);
  Triangles fan;
  for (size_t i = 0; i < ring.size(); ++i) fan.push_back(triangle(hub, ring[i], ring[(i + 1) % ring.size()]));
  for (int i = 0; i < 200000; ++i) {
    const Vec3 origin(unit(random), unit(random), 5);
    const float along = 0.5f + 0.45f * unit(random);
    const Vec3 target = glm::mix(hub, ring[size_t(i) % ring.size()], i % 7 ? along : 0.0f);  // on an edge, or the hub
    const ShearedRay ray({origin, glm::normalize(target - origin)});
    bool met = false;
    Hit hit;
    for (const HotTriangle &t : fan) met |= intersectTriangle(ray, t, hit);
    ASSERT_TRUE(met) << "ray " << i << " slipped through";
  }
}

TEST(Traversal, EqualDistancesGoToTheLowerPrimitive) {
  const HotTriangle t = triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh, AccelKind::Exhaustive}) {
    TestScene scene({t, t, t}, kind);
    const Hit first = closestHit(scene.update(), {{0, 0, 2}, {0, 0, -1}});
    EXPECT_EQ(first.primitive, 0u);
    const Hit second = nextHit(scene.update(), {{0, 0, 2}, {0, 0, -1}}, {first.t, first.primitive}, kInfinity);
    EXPECT_EQ(second.primitive, 1u);
    EXPECT_EQ(second.t, first.t);
  }
}

TEST(Texture, WrapModes) {
  EXPECT_EQ(wrapIndex(17, 16, Wrap::Repeat), 1);
  EXPECT_EQ(wrapIndex(-1, 16, Wrap::Repeat), 15);
  EXPECT_EQ(wrapIndex(17, 16, Wrap::ClampToEdge), 15);
  EXPECT_EQ(wrapIndex(-3, 16, Wrap::ClampToEdge), 0);
  EXPECT_EQ(wrapIndex(16, 16, Wrap::MirroredRepeat), 15);
  EXPECT_EQ(wrapIndex(-1, 16, Wrap::MirroredRepeat), 0);
  EXPECT_EQ(wrapIndex(33, 16, Wrap::MirroredRepeat), 1);
}

class TextureFilter : public testing::Test {
 protected:
  // 2 x 2: red grows with u, green with v; one coarser texel of half red, half green.
  TextureFilter() {
    mView.levels = {mBase, mCoarse};
    mView.width = mView.height = 2;
    mView.levelCount = 2;
  }
  Vec4 at(float u, float v, float lod) const {
    return sampleTexture(mView, {u, v}, {Wrap::ClampToEdge, Wrap::ClampToEdge}, lod);
  }
  uint32_t mBase[4] = {0xff000000, 0xff0000ff, 0xff00ff00, 0xff00ffff};
  uint32_t mCoarse[1] = {0xff008080};
  TextureView mView;
};

TEST_F(TextureFilter, BilinearBetweenTexelCentres) {
  EXPECT_FLOAT_EQ(at(0.25f, 0.25f, 0).x, 0);
  EXPECT_FLOAT_EQ(at(0.75f, 0.25f, 0).x, 1);
  EXPECT_FLOAT_EQ(at(0.5f, 0.25f, 0).x, 0.5f);
  EXPECT_FLOAT_EQ(at(0.5f, 0.625f, 0).y, 0.75f);
  EXPECT_FLOAT_EQ(at(0.0f, 0.75f, -9).y, 1) << "magnified and clamped";
}

TEST_F(TextureFilter, NearestLevelOrBetweenLevels) {
  EXPECT_FLOAT_EQ(at(0.75f, 0.25f, 0.4f).x, 1);
  EXPECT_NEAR(at(0.75f, 0.25f, 0.6f).x, 0.5, 0.01);
  EXPECT_NEAR(at(0.75f, 0.25f, 99).x, 0.5, 0.01) << "beyond the last level";
  mView.trilinear = true;
  EXPECT_NEAR(at(0.75f, 0.25f, 0.5f).x, 0.75, 0.01);
}

TEST_F(TextureFilter, CoordinatesThatAreNoNumbersDoNoHarm) {
  for (float bad : {kInfinity, -kInfinity, std::nanf(""), 1e30f}) {
    const Vec4 texel = sampleTexture(mView, {bad, 0.25f}, {Wrap::Repeat, Wrap::Repeat}, std::nanf(""));
    EXPECT_GE(texel.x, 0);
    EXPECT_LE(texel.x, 1);
  }
}

TEST(Texture, SixteenIsOpaque) {
  TextureView texture;
  EXPECT_FLOAT_EQ(opacityOf(MaterialRow{}, texture, 0), 0);
  EXPECT_FLOAT_EQ(opacityOf(MaterialRow{}, texture, 8 / 255.0f), 0.5f);
  EXPECT_FLOAT_EQ(opacityOf(MaterialRow{}, texture, 16 / 255.0f), 1);
  EXPECT_FLOAT_EQ(opacityOf(MaterialRow{}, texture, 1), 1);
  texture.opaqueAlpha = 255;
  EXPECT_NEAR(opacityOf(MaterialRow{}, texture, 128 / 255.0f), 0.502, 0.001);
}

SurfacePoint pointAt(const Vec3 &position, const Vec3 &normal) {
  SurfacePoint point;
  point.position = position;
  point.normal = point.flatNormal = normal;
  return point;
}

const SurfaceColours kWhite{Rgb(1), Rgb(1), Rgb(1), 3, leastShineOf(3)};

TEST(Lighting, PhongHighlightIsTimesNL) {
  LightRow light;
  light.directional = true;
  light.position = glm::normalize(Vec3(1, 0, 1));
  light.ambient = Rgb(0.25f);
  light.diffuse = Rgb(0.5f);
  light.specular = Rgb(1);
  const Vec3 view = glm::normalize(Vec3(-1, 0, 2));
  const LightTerm term = lightAt(light, pointAt({}, {0, 0, 1}), view, kWhite);
  const float nl = std::sqrt(0.5f), rv = glm::dot(glm::normalize(Vec3(-1, 0, 1)), view);
  EXPECT_FLOAT_EQ(term.ambient.x, 0.25f);
  EXPECT_NEAR(term.direct.x, nl * (0.5f + std::pow(rv, 3.0f)), 1e-6);
  EXPECT_EQ(term.distance, kInfinity);
}

TEST(Lighting, NothingDirectFromBehind) {
  LightRow light;
  light.position = {0, 0, -1};
  const LightTerm term = lightAt(light, pointAt({}, {0, 0, 1}), {0, 0, 1}, kWhite);
  EXPECT_EQ(term.direct, Rgb(0));
  EXPECT_EQ(term.ambient, Rgb(1));
}

TEST(Lighting, AttenuationByCoefficientsAndRange) {
  LightRow light;
  light.directional = false;
  light.constant = 1, light.linear = 0.5f, light.quadratic = 0.25f;
  EXPECT_FLOAT_EQ(attenuation(light, 2), 1 / (1 + 1 + 1.0f));
  light.rangeStart = 1, light.rangeEnd = 5;
  EXPECT_FLOAT_EQ(attenuation(light, 2), 0.75f / 3);
  EXPECT_FLOAT_EQ(attenuation(light, 6), 0);
  light.rangeEnd = 1;
  EXPECT_FLOAT_EQ(attenuation(light, 2), 1 / 3.0f) << "off while end <= start";
  light.constant = light.linear = light.quadratic = 0;
  EXPECT_FLOAT_EQ(attenuation(light, 2), 1);
  light.directional = true;
  light.linear = 1;
  EXPECT_FLOAT_EQ(attenuation(light, 2), 1) << "directional lights are not attenuated";
}

TEST(Lighting, SpotConeWithHermiteEdgeAndExponent) {
  LightRow light;
  light.spot = true;
  light.spotDirection = {0, -1, 0};
  light.cosInner = std::cos(glm::radians(10.0f));
  light.cosOuter = std::cos(glm::radians(30.0f));
  const auto at = [&](float degrees) {
    return spotFactor(light, {std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0});
  };
  EXPECT_FLOAT_EQ(at(5), 1);
  EXPECT_FLOAT_EQ(at(31), 0);
  const float s = (std::cos(glm::radians(20.0f)) - light.cosOuter) / (light.cosInner - light.cosOuter);
  EXPECT_NEAR(at(20), s * s * (3 - 2 * s), 1e-5);
  light.spotExponent = 4;
  EXPECT_NEAR(at(5), std::pow(std::cos(glm::radians(5.0f)), 4), 1e-5);
}

TEST(HitPoint, NormalsAreTurnedToTheRayAndOffsetsGrowWithDistance) {
  TestScene scene({triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 0, kHasNormals)});
  for (Vec3 &normal : scene.attributes[0].normal) normal = glm::normalize(Vec3(0.2f, 0, 1));
  const GeometryView &geometry = scene.update().geometry[0];
  const Hit hit{1, 0.25f, 0.25f, 0};
  const SurfacePoint front = surfacePoint(geometry, 0, hit, {0, 0, -1}),
                     back = surfacePoint(geometry, 0, hit, {0, 0, 1});
  EXPECT_TRUE(front.front);
  EXPECT_FALSE(back.front);
  EXPECT_GT(front.normal.z, 0);
  EXPECT_LT(back.normal.z, 0);
  EXPECT_FLOAT_EQ(front.normal.x, -back.normal.x);
  EXPECT_GT(front.start({0, 0, 1}).z, 0) << "off the plane although all its coordinates are 0";
  EXPECT_LT(front.start({0, 0, -1}).z, 0);
}

TEST(Framebuffer, ColoursAreStoredByFloorOf256) {
  const auto red = [](float c) { return packColour({c, 0, 0}) & 255; };
  EXPECT_EQ(red(0), 0u);
  EXPECT_EQ(red(-1), 0u);
  EXPECT_EQ(red(0.3f), 76u);
  EXPECT_EQ(red(0.5f), 128u);
  EXPECT_EQ(red(0.999f), 255u);
  EXPECT_EQ(red(1), 255u);
  EXPECT_EQ(red(1e30f), 255u);
  EXPECT_EQ(red(std::nanf("")), 0u);
  EXPECT_EQ(packColour({0, 0, 0}) >> 24, 255u);
}

TEST(Lighting, HighlightsAreLeftOutWhereNobodySeesThem) {
  for (const float shininess : {0.01f, 1.0f, 3.0f, 40.0f, 128.0f}) {
    const float least = leastShineOf(shininess);
    EXPECT_LT(powOf(least, shininess), 0x1.01p-30f) << shininess;
    EXPECT_TRUE(least < 1e-30f || powOf(least * 1.1f, shininess) > 0x1p-30f) << shininess;
  }
  EXPECT_LT(leastShineOf(0), -1) << "without shininess it shines everywhere";
}

// As texture units widen such texels: 31 of 31 is 255 again.
TEST(Framebuffer, FiveSixAndFiveBitsRepeatTheirUpperOnes) {
  for (uint32_t byte = 0; byte < 256; ++byte) {
    const uint32_t rounded = roundTo565(byte | byte << 8 | byte << 16 | 0xff000000u);
    EXPECT_EQ(rounded & 255, byte >> 3 << 3 | byte >> 5) << byte;
    EXPECT_EQ(rounded >> 8 & 255, byte >> 2 << 2 | byte >> 6) << byte;
    EXPECT_EQ(rounded >> 16 & 255, rounded & 255) << byte;
    EXPECT_EQ(rounded >> 24, 255u);
    EXPECT_EQ(roundTo565(rounded), rounded) << "what is there already stays";
  }
}

}  // namespace
}  // namespace rc::test
