// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Rays that leave a surface neither meet it again nor pass what lies close to it: for scenes from a millionth to a
// million units large, and a hundred thousand of their sizes away from the origin.
#include <gtest/gtest.h>

#include "common/meshes.h"
#include "rchal/framebuffer.h"
#include "rchal/units/shadow_ray.h"

namespace rc::test {
namespace {

using namespace rc::hal;

struct Place {
  const char *name;
  float size, distance;
};
constexpr Place kPlaces[] = {
    {"Millionth", 1e-6f, 0},
    {"Thousandth", 1e-3f, 0},
    {"One", 1, 0},
    {"Thousand", 1e3f, 0},
    {"Million", 1e6f, 0},
    {"OneFarAway", 1, 1e5f},
    {"TinyNearOne", 1e-4f, 1},
    {"ThousandFarAway", 1e3f, 1e5f},
};

bool isSliver(const HotTriangle &t) {
  float longest = 0;
  for (const Vec3 &edge : {t.v1 - t.v0, t.v2 - t.v1, t.v0 - t.v2}) longest = std::max(longest, glm::dot(edge, edge));
  return longest > kSliver * t.doubleArea;
}

class Offsets : public testing::TestWithParam<Place> {
 protected:
  static constexpr int kTriangles = 400, kDirections = 60;
  static constexpr float kNeedle = 1000;  // times longer than wide

  float unit() { return std::uniform_real_distribution<float>(0, 1)(mRandom); }
  Vec3 direction() {
    const Vec3 d{unit() - 0.5f, unit() - 0.5f, unit() - 0.5f};
    return normalizedOr(d, {0, 1, 0});
  }
  // Every third one is a needle, every third one lies in a coordinate plane.
  HotTriangle someTriangle(int i) {
    const float size = GetParam().size;
    const Vec3 centre = GetParam().distance * direction();
    Vec3 a = centre + size * direction(), b = centre + size * direction(), c = centre + size * direction();
    if (i % 3 == 1) {
      const Vec3 across = normalizedOr(glm::cross(b - a, direction()), {1, 0, 0});
      c = a + unit() * (b - a) + (glm::length(b - a) / kNeedle) * across;
    }
    if (i % 3 == 2) a[i % 9 / 3] = b[i % 9 / 3] = c[i % 9 / 3] = centre[i % 9 / 3];
    return triangle(a, b, c);
  }
  // A place of the triangle as a ray from outside finds it; nothing if it misses by rounding.
  std::optional<SurfacePoint> somePoint(TestScene &scene) {
    const HotTriangle &t = scene.triangles[0];
    float u = unit(), v = unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 at = t.v0 + u * (t.v1 - t.v0) + v * (t.v2 - t.v0);
    const Vec3 from = at + GetParam().size * 3.0f * direction();
    const Ray ray{from, glm::normalize(at - from)};
    const SceneView &view = scene.update();
    const Hit hit = closestHit(view, ray);
    if (!hit.found()) return std::nullopt;
    return surfacePoint(view.geometry[0], 0, hit, ray.direction);
  }
  // On either side, all but along the surface too.
  Vec3 leaving(const SurfacePoint &point) {
    const Vec3 along = normalizedOr(glm::cross(point.flatNormal, direction()), {1, 0, 0});
    const float height = std::pow(10.0f, -5 * unit()) * (unit() < 0.5f ? -1.0f : 1.0f);
    return glm::normalize(along + height * point.flatNormal);
  }

  std::mt19937 mRandom{1};
};

TEST_P(Offsets, NoRayMeetsTheSurfaceItLeaves) {
  int tried = 0, met = 0;
  for (int i = 0; i < kTriangles; ++i) {
    TestScene scene({someTriangle(i)}, AccelKind::Exhaustive);
    for (int k = 0; k < kDirections; ++k) {
      const auto point = somePoint(scene);
      if (!point) continue;
      const Vec3 away = leaving(*point);
      ++tried;
      met += closestHit(scene.view, {point->start(away), away}).found();
    }
  }
  EXPECT_GT(tried, kTriangles * kDirections / 2);
  EXPECT_EQ(met, 0) << "of " << tried;
}

// From lights on either side, up to as far off as they send rays, all but beside the surface too; if they lie on a side
// as far as float can tell.
TEST_P(Offsets, NoRayFromALightMeetsTheSurfaceItEndsAt) {
  int tried = 0, met = 0;
  LightRow light;
  light.directional = false;
  light.sendsShadowRays = true;
  for (int i = 0; i < kTriangles; ++i) {
    TestScene scene({someTriangle(i)}, AccelKind::Exhaustive);
    for (int k = 0; k < kDirections; ++k) {
      const auto point = somePoint(scene);
      if (!point) continue;
      LightTerm term;
      light.position = point->position + kFarLight * GetParam().size * unit() * leaving(*point);
      term.towards = light.position - point->position;
      if (std::abs(glm::dot(term.towards, point->flatNormal)) < point->safeOffset) continue;
      term.distance = glm::length(term.towards);
      term.direction = directionOf(term.towards, term.distance, point->flatNormal);
      ++tried;
      met += isBlocked(scene.view, shadowRay(light, *point, term), reachOf(light));
    }
  }
  EXPECT_GT(tried, kTriangles * kDirections / 5);
  EXPECT_EQ(met, 0) << "of " << tried;
}

// Twice the offset is enough of a gap.
TEST_P(Offsets, ASheetCloseByIsMet) {
  int tried = 0, passed = 0;
  for (int i = 0; i < kTriangles; ++i) {
    TestScene below({someTriangle(i)}, AccelKind::Exhaustive);
    const auto point = somePoint(below);
    // Far away a float cannot tell slivers from lines.
    if (!point || (GetParam().distance > 0 && isSliver(below.triangles[0]))) continue;
    HotTriangle above = below.triangles[0];
    const Vec3 centre = (above.v0 + above.v1 + above.v2) / 3.0f;
    for (Vec3 *v : {&above.v0, &above.v1, &above.v2}) {
      *v += (2 * point->safeOffset) * point->flatNormal + 3.0f * (*v - centre);
    }
    TestScene scene({below.triangles[0], above});
    const SceneView &view = scene.update();
    const Ray ray{point->start(point->flatNormal), point->flatNormal};
    ++tried;
    passed += closestHit(view, ray).primitive != 1 || !isBlocked(view, ray, {.end = GetParam().size});
  }
  EXPECT_GT(tried, kTriangles / 2);
  EXPECT_EQ(passed, 0) << "of " << tried;
}

// How near that is: 2^-19 of the coordinates, but for slivers.
TEST_P(Offsets, AreAFewStepsOfFloat) {
  for (int i = 0; i < 50; ++i) {
    TestScene scene({someTriangle(i)}, AccelKind::Exhaustive);
    const auto point = somePoint(scene);
    if (!point || isSliver(scene.triangles[0])) continue;
    const HotTriangle &t = scene.triangles[0];
    EXPECT_LE(point->safeOffset, largestCoordinate(t.v0, t.v1, t.v2) * 0x1p-19f);
    EXPECT_GT(point->safeOffset, 0);
  }
}

// A tilted mirror under the sky shows the sky in all pixels, a lit floor is lit everywhere.
class OpenFloor : public Offsets {
 protected:
  std::vector<uint32_t> picture(const char *device, const MaterialRow &material, bool fromLight = false) {
    const float size = GetParam().size;
    const Vec3 centre = GetParam().distance * glm::normalize(Vec3(3, -2, 1));
    const Vec3 x = size * glm::normalize(Vec3(1, 0.2f, 0.1f)), z = size * glm::normalize(Vec3(-0.1f, 0.3f, 1));
    TestScene scene(
        gridSurface(6, [&](float u, float v) { return centre + 8.0f * ((u - 0.5f) * x + (v - 0.5f) * z); }));
    scene.materials[0] = material;
    const Vec3 up = normalizedOr(glm::cross(z, x), {0, 1, 0});
    LightRow light;
    light.directional = false;
    light.sendsShadowRays = fromLight;
    light.position = centre + 20 * size * up;
    light.diffuse = Rgb(1);
    scene.lights = {light};
    SceneView view = scene.update();
    view.camera = {.eye = centre + 4 * size * up, .left = -0.5f, .bottom = -0.5f, .width = 1, .height = 1, .near = 1};
    view.camera.right = glm::normalize(x);
    view.camera.up = glm::cross(up, view.camera.right);
    view.camera.back = up;
    view.camera.columns = view.camera.rows = kSide;
    view.clearColor = {0.2f, 0.4f, 0.6f};
    view.maxBounces = 3;
    std::vector<uint32_t> pixels(size_t(kSide) * kSide);
    createDevice(device, 1)->trace(view, {pixels.data(), kSide, kSide});
    return pixels;
  }

  static constexpr int kSide = 32;
};

TEST_P(OpenFloor, MirrorsShowTheSkyAlone) {
  MaterialRow mirror;
  mirror.ambient = mirror.diffuse = mirror.specular = Rgb(0);
  mirror.reflection = Rgb(1);
  for (const char *device : {"cpu", "ref"}) {
    for (const uint32_t pixel : picture(device, mirror)) ASSERT_EQ(pixel, packColour({0.2f, 0.4f, 0.6f})) << device;
  }
}

TEST_P(OpenFloor, HasNoSpecksOfShadow) {
  MaterialRow matt;
  matt.ambient = matt.specular = Rgb(0);
  matt.diffuse = Rgb(1);
  for (const char *device : {"cpu", "ref"}) {
    for (const bool fromLight : {false, true}) {
      for (const uint32_t pixel : picture(device, matt, fromLight)) ASSERT_GT(pixel & 255, 200u) << device << fromLight;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Places, Offsets, testing::ValuesIn(kPlaces),
                         [](const auto &place) { return std::string(place.param.name); });
INSTANTIATE_TEST_SUITE_P(Places, OpenFloor, testing::ValuesIn(kPlaces),
                         [](const auto &place) { return std::string(place.param.name); });

}  // namespace
}  // namespace rc::test
