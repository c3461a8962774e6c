// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Footprints of rays: what a curved surface does to them, against the optics of a sphere. [units/ray_cone.h]
#include "rchal/units/ray_cone.h"

#include <gtest/gtest.h>

namespace rc::hal {
namespace {

// A small triangle on a sphere about the origin, around the +z axis, with the sphere's normals.
struct SphereTriangle {
  explicit SphereTriangle(float radius) {
    const float size = 0.05f * radius;
    Vec3 *corners[3] = {&triangle.v0, &triangle.v1, &triangle.v2};
    for (int i = 0; i < 3; ++i) {
      const float angle = 2.0944f * static_cast<float>(i);
      const Vec3 normal = glm::normalize(Vec3(size * std::cos(angle), size * std::sin(angle), radius));
      *corners[i] = radius * normal;
      attributes.normal[i] = normal;
    }
    triangle.flags = kHasNormals;
  }
  HotTriangle triangle{};
  TriangleAttributes attributes{};
};

TEST(RayCone, CurvatureOfASphere) {
  for (float radius : {0.1f, 1.0f, 50.0f}) {
    const SphereTriangle sphere(radius);
    EXPECT_NEAR(curvature(sphere.triangle, sphere.attributes, {0, 0, 1}), 1 / radius, 0.01f / radius) << "outside";
    EXPECT_NEAR(curvature(sphere.triangle, sphere.attributes, {0, 0, -1}), -1 / radius, 0.01f / radius) << "inside";
  }
}

TEST(RayCone, AFlatTriangleHasNone) {
  SphereTriangle flat(1);
  flat.triangle.flags = 0;
  EXPECT_EQ(curvature(flat.triangle, flat.attributes, {0, 0, 1}), 0);
  EXPECT_EQ(reflectedSpread(0.25f, 3, 0), 0.25f);
  EXPECT_EQ(refractedSpread(0.25f, 3, 0, 1), 0.25f);
}

// Parallel rays of a beam of width w meet behind a concave mirror at half its radius.
TEST(RayCone, AConcaveMirrorFocusesAtHalfItsRadius) {
  constexpr float kRadius = 4, kWidth = 0.01f;
  const float spread = reflectedSpread(0, kWidth, -1 / kRadius);
  EXPECT_NEAR(kWidth + spread * kRadius / 2, 0, 1e-6f);
}

// A single surface with index n behind it focuses at n R / (n - 1).
TEST(RayCone, AGlassSurfaceFocusesWhereOpticsSay) {
  constexpr float kRadius = 2, kWidth = 0.01f, kIndex = 1.5f;
  const float spread = refractedSpread(0, kWidth, 1 / kRadius, 1 / kIndex);
  EXPECT_NEAR(kWidth + spread * kIndex * kRadius / (kIndex - 1), 0, 1e-6f);
}

}  // namespace
}  // namespace rc::hal
