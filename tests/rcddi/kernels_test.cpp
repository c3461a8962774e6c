// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The kernels of the cpu device on each instruction set that this machine has, against the scalar unit without a
// structure: hits equal to the last bit, and the same shadow rays blocked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "common/on_each_target.h"
#include "common/ray_kinds.h"
#include "rchal/units/hit_point.h"
#include "rchal/units/traversal.h"

namespace rc::test {
namespace {

using namespace rc::hal;

const size_t kRays = raysFromEnvironment(3000);

bool sameBits(const Hit &a, const Hit &b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

size_t compareHits(const SceneView &scene, const SceneView &plain, std::span<const Ray> rays) {
  const Columns columns(rays);
  std::vector<Hit> truth(rays.size());
  size_t found = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    truth[i] = closestHit(plain, rays[i]);
    found += truth[i].found();
  }
  onEachTarget([&] {
    const std::vector<Hit> hits = closestHits(scene, columns);
    size_t different = 0;
    for (size_t i = 0; i < rays.size() && different < 3; ++i) {
      if (sameBits(hits[i], truth[i])) continue;
      ++different;
      ADD_FAILURE() << "ray " << i << ": " << hits[i].primitive << " at " << hits[i].t << ", should be "
                    << truth[i].primitive << " at " << truth[i].t;
    }
  });
  return found;
}

// Of a ray that nothing blocks: where it crosses triangles that let light through.
std::vector<Hit> crossings(const SceneView &plain, const Ray &ray, const Reach &reach) {
  std::vector<Hit> out;
  forEachHit(plain, ray, reach, [&](const Hit &hit) {
    const auto [geometry, index] = placeOf(plain, hit.primitive);
    if (passageOf(geometry, index, reach.towardsLight(ray.direction)) == Passage::Filtered) out.push_back(hit);
    return true;
  });
  return out;
}

std::vector<Hit> crossings(const ddi::cpu::FilterHits &filters, size_t ray) {
  std::vector<Hit> out;
  filters.forEach(ray, [&](const Hit &hit) {
    out.push_back(hit);
    return true;
  });
  return out;
}

// common: rays are known to start at one point.
void compareBlocked(const SceneView &scene, const SceneView &plain, std::span<const Ray> rays, const Reach &reach,
                    bool common = false) {
  const Columns columns(rays);
  ddi::cpu::RayStream stream = columns.stream();
  stream.reach = reach;
  stream.common = common;
  std::vector<uint8_t> truth(rays.size());
  std::vector<std::vector<Hit>> crossed(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    truth[i] = isBlocked(plain, rays[i], reach);
    if (!truth[i]) crossed[i] = crossings(plain, rays[i], reach);
  }
  onEachTarget([&] {
    std::vector<uint8_t> blocked(rays.size());
    ddi::cpu::FilterHits filters;
    filters.reset(rays.size());
    ddi::cpu::findBlocked(scene, stream, blocked.data(), &filters);
    size_t different = 0;
    for (size_t i = 0; i < rays.size() && different < 3; ++i) {
      const bool tooMany = crossed[i].size() > ddi::cpu::FilterHits::kMost;
      if (filters.hasTooMany(i) && (tooMany || truth[i])) continue;
      const bool same =
          blocked[i] == truth[i] && (truth[i] || std::ranges::equal(crossings(filters, i), crossed[i], sameBits));
      different += !same;
      EXPECT_TRUE(same) << "ray " << i;
    }
  });
}

// A scene of two sets, so that primitive numbers run on; some triangles filter light, some have one side.
class Kernels : public testing::TestWithParam<std::tuple<RayKind, AccelKind>> {
 protected:
  void compare(const Triangles &statics, const Triangles &dynamics, size_t count) {
    const auto [rayKind, accelKind] = GetParam();
    TestScene scene(filtering(statics), accelKind), second(filtering(dynamics), accelKind);
    SceneView view = scene.update();
    view.geometry[1] = second.update().geometry[0];
    SceneView plain = view;
    for (GeometryView &geometry : plain.geometry) geometry.accel = {};
    const std::vector<Ray> rays = raysOf(rayKind, count, view);
    EXPECT_GT(compareHits(view, plain, rays), rays.size() / 20) << "the rays miss nearly everything";
    compareBlocked(view, plain, rays, {.end = 0.7f});
    compareBlocked(view, plain, rays, {.begin = 0.2f, .end = 3, .fromLight = true});
  }

 private:
  static Triangles filtering(Triangles triangles) {
    for (size_t i = 0; i < triangles.size(); i += 7) triangles[i].flags |= kTransmittanceShadow;
    for (size_t i = 2; i < triangles.size(); i += 5) triangles[i].flags |= kCullBack;
    return triangles;
  }
};

TEST_P(Kernels, Terrain) { compare(terrain(24), {}, kRays); }
TEST_P(Kernels, KnotOverTerrain) { compare(terrain(6), knot(12), kRays); }
TEST_P(Kernels, Soup) { compare(soup(300, 3), soup(40, 4), kRays); }
TEST_P(Kernels, GridWhoseLinesTheRaysFollow) {
  compare(gridSurface(12, [](float u, float v) { return Vec3(u, 0.25f * u, v); }), {}, kRays);
}
TEST_P(Kernels, FewTriangles) { compare({triangle({-2, -2, 0}, {2, -2, 0}, {0, 2, 0})}, soup(6, 1), kRays); }

INSTANTIATE_TEST_SUITE_P(Rays, Kernels,
                         testing::Combine(testing::ValuesIn(kAllRayKinds),
                                          testing::Values(AccelKind::Bvh, AccelKind::KdTree)),
                         [](const auto &test) {
                           return nameOf(std::get<RayKind>(test.param)) + nameOf(std::get<AccelKind>(test.param));
                         });

// Six walls of the cube from -1 to 1, of n x n squares each, and panels from wall to wall.
Triangles room(int n) {
  Triangles triangles;
  const auto add = [&](int cells, const Vec3 &corner, const Vec3 &u, const Vec3 &v) {
    for (const auto &t : gridSurface(cells, [&](float a, float b) { return corner + a * u + b * v; })) {
      triangles.push_back(t);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 u(0), v(0), w(0);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = w[axis] = 2;
    add(n, Vec3(-1), u, v);
    add(n, Vec3(-1) + w, u, v);
    add(1, Vec3(-1) + 0.6f * w + 0.7f * u, 0.15f * u + 0.05f * w, v);
  }
  return triangles;
}

// Where a ray from within leaves that cube.
float exitOf(const Ray &ray, float scale) {
  float t = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const float wall = std::copysign(scale, ray.direction[axis]);
    t = std::min(t, (wall - ray.origin[axis]) / ray.direction[axis]);
  }
  return t;
}

// A group of rays from a point, about a direction.
std::vector<Ray> fan(const Vec3 &origin, const Vec3 &direction, float width) {
  const Vec3 u = glm::normalize(glm::cross(direction, Vec3(0.3f, 0.5f, -0.7f))), v = glm::cross(direction, u);
  std::vector<Ray> rays;
  for (int i = 0; i < 256; ++i) {
    const int block = i / 16, x = block % 4 * 4 + i % 4, y = block / 4 * 4 + i / 4 % 4;
    rays.push_back({origin, direction + width * ((float(x) / 16 - 0.5f) * u + (float(y) / 16 - 0.5f) * v)});
  }
  return rays;
}

// From within: triangles on both sides of where rays meet, an eye or a light, which may touch them.
TEST(KernelRooms, EyesAndLightsAmidWalls) {
  for (const float scale : {1e-10f, 1e-6f, 1.0f, 1e6f}) {
    Triangles triangles = room(2);
    for (HotTriangle &t : triangles) t = triangle(scale * t.v0, scale * t.v1, scale * t.v2);
    TestScene scene(triangles);
    const SceneView view = scene.update();
    SceneView plain = view;
    plain.geometry[0].accel = {};
    SCOPED_TRACE(scale);
    for (const Vec3 &place : {Vec3(0.1f, 0.2f, -0.3f), Vec3(0.999f, 0.1f, 0), Vec3(0.2f, 0.9999999f, 0.3f),
                              Vec3(-1, 0.3f, 0.2f), Vec3(1, 1, 0.5f), Vec3(0.5f, 0.3f, 0.4f)}) {
      std::vector<Ray> out, in, on;  // from the place, towards it, away from it: as if seen in a mirror
      for (const Vec3 &about : {Vec3(1, 0.2f, 0.1f), Vec3(-0.9f, 0.3f, 0.2f), Vec3(0.1f, 1, 0.1f), Vec3(0.2f, -1, 0.4f),
                                Vec3(0, 0, 1), Vec3(0.3f, 0.2f, -1)}) {
        for (const Ray &ray : fan(scale * place, about, 0.3f)) {
          out.push_back(ray);
          const Vec3 from = ray.origin + 0.999f * exitOf(ray, scale) * ray.direction;
          in.push_back({from, ray.origin - from});
          const float miss = out.size() % 3 ? 0.0f : 1e-3f * scale;  // or nearly from there
          on.push_back({ray.origin + 0.2f * scale * ray.direction + Vec3(miss, 0, -miss), ray.direction});
        }
      }
      compareHits(view, plain, out);
      compareHits(view, plain, on);
      compareBlocked(view, plain, on, {.end = 10});
      for (const float end : {0.999f, 1.0f, 1.0005f, 1.5f}) compareBlocked(view, plain, in, {.end = end});
      compareBlocked(view, plain, out, {.begin = 1e-5f, .end = 0.9f * scale, .fromLight = true}, true);
    }
  }
}

// Rays from a floor to a light, below a canopy. That a ray cannot meet some triangle, the one that it starts on or,
// here too, one that its neighbour meets, may be made use of for this ray alone.
TEST(KernelOrigins, TrianglesThatARayCannotMeetChangeNothing) {
  Triangles triangles = gridSurface(4, [](float u, float v) { return Vec3(4 * u - 2, 0.1f * u, 4 * v - 2); });
  for (const HotTriangle &t : gridSurface(5, [](float u, float v) { return Vec3(u - 0.6f, 1 + 0.1f * v, v - 0.3f); })) {
    triangles.push_back(t);
  }
  TestScene scene(triangles);
  const SceneView view = scene.update();
  const Vec3 light(0.4f, 3, 0.7f);
  std::vector<Ray> rays;
  std::vector<uint32_t> origins, neighbours;
  for (size_t i = 0; i < 64 * 64; ++i) {
    const size_t column = i % 64, row = i / 64;
    const Ray down{{float(column) / 16 - 1.97f, 0.9f, float(row) / 16 - 1.96f}, {0, -1, 0}};
    const Hit hit = closestHit(view, down);
    ASSERT_TRUE(hit.found());
    const SurfacePoint point = surfacePoint(view.geometry[0], hit.primitive, hit, down.direction);
    const Vec3 towards = light - point.position;
    rays.push_back({point.start(towards), towards});
    origins.push_back(hit.primitive);
  }
  std::vector<uint8_t> truth(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    const uint32_t own = closestHit(view, rays[i]).primitive, other = closestHit(view, rays[i ^ 1]).primitive;
    truth[i] = own != kNoPrimitive;
    neighbours.push_back(own == other ? kNoPrimitive : other);
  }
  EXPECT_GT(std::ranges::count(truth, 1), 300);
  EXPECT_GT(std::ranges::count(truth, 0), 300);
  const Columns columns(rays);
  for (std::vector<uint32_t> *from : {&origins, &neighbours}) {
    from->resize(rays.size() + Columns::kBehind, kNoPrimitive);
    onEachTarget([&] {
      ddi::cpu::RayStream stream = columns.stream();
      stream.from = from->data();
      stream.reach.end = 1;
      std::vector<uint8_t> blocked(rays.size());
      ddi::cpu::findBlocked(view, stream, blocked.data(), nullptr);
      EXPECT_EQ(blocked, truth);
    });
  }
}

// Numbers beyond what margins cover: the scalar unit takes over.
TEST(KernelLimits, HugeAndTinyNumbers) {
  Triangles triangles = soup(50, 8);
  triangles.push_back(triangle({-1e15f, -1e15f, 5}, {1e15f, -1e15f, 5}, {0, 1e15f, 5}));
  TestScene scene(triangles);
  const SceneView view = scene.update();
  SceneView plain = view;
  plain.geometry[0].accel = {};
  std::vector<Ray> rays = randomRays(1000, 4);
  for (size_t i = 0; i < rays.size(); i += 3) rays[i].direction *= 1e-15f;
  for (size_t i = 1; i < rays.size(); i += 3) rays[i].origin *= 1e14f;
  EXPECT_GT(compareHits(view, plain, rays), rays.size() / 20);
}

// A ray that is no number hits nothing, and spoils nothing for its neighbours.
TEST(KernelLimits, RaysThatAreNoNumbers) {
  TestScene scene(terrain(10));
  const SceneView view = scene.update();
  SceneView plain = view;
  plain.geometry[0].accel = {};
  for (int which = 0; which < 6; ++which) {
    std::vector<Ray> rays = raysOf(RayKind::Camera, 256, view);
    (which < 3 ? rays[37].origin : rays[37].direction)[which % 3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_GT(compareHits(view, plain, rays), 10u);
    compareBlocked(view, plain, rays, {.end = 5});
  }
}

// Depths behind a beam are rounded by the farthest of its rays' origins: of these rays one meets two triangles at their
// common vertex, the nearer one second.
TEST(KernelLimits, OriginsNearAndFarInOneBeam) {
  TestScene scene(knot(48));
  const SceneView view = scene.update();
  EXPECT_GT(compareHits(view, view, raysOf(RayKind::FarAxis, 28000, view)), 20000u);
}

// Numbers of rays that fill neither packets nor groups.
TEST(KernelLimits, AnyNumberOfRays) {
  TestScene scene(terrain(10));
  const SceneView view = scene.update();
  SceneView plain = view;
  plain.geometry[0].accel = {};
  const std::vector<Ray> rays = raysOf(RayKind::Camera, 300, view);
  for (size_t count : {1, 2, 15, 16, 17, 255, 257}) compareHits(view, plain, std::span(rays).first(count));
}

}  // namespace
}  // namespace rc::test
