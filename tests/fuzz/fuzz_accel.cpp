// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Triangles as no scene should have them, and rays through them: every acceleration structure gives the hits that
// trying all triangles gives, built at once, quickly for one frame, or fitted to triangles that have moved.
#include <cstdio>
#include <cstdlib>

#include "common/meshes.h"
#include "input.h"
#include "rchal/units/traversal.h"

namespace rc::fuzz {
namespace {

using namespace rc::hal;
using rc::test::Triangles;

constexpr size_t kMostTriangles = 768;

Vec3 point(Input &in) {
  const float x = in.number(), y = in.number(), z = in.number();
  return {x, y, z};
}

// What the assembler lets through to the structures. [rcddk/assembler.h]
bool usable(const HotTriangle &t) {
  const Vec3 edges = glm::cross(t.v1 - t.v0, t.v2 - t.v0);
  return isFinite(t.v0 + t.v1 + t.v2) && isFinite(edges) && glm::length(edges) > 0;
}

void add(Triangles &all, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const HotTriangle t = test::triangle(a, b, c);
  if (all.size() < kMostTriangles && usable(t)) all.push_back(t);
}

void addFree(Input &in, Triangles &all) {
  const Vec3 a = point(in), b = point(in), c = point(in);
  add(all, a, b, c);
}

void addEqual(Input &in, Triangles &all) {
  const Vec3 a = point(in), b = point(in), c = point(in);
  for (size_t n = in.byte(); n > 0; --n) add(all, a, b, c);
}

// A grid in a plane, in cells of any proportion.
void addGrid(Input &in, Triangles &all) {
  const Vec3 origin = point(in), u = point(in), v = point(in);
  const size_t columns = 1 + in.below(16), rows = 1 + in.below(16);
  for (size_t i = 0; i < columns; ++i) {
    for (size_t j = 0; j < rows; ++j) {
      const auto at = [&](size_t di, size_t dj) { return origin + float(i + di) * u + float(j + dj) * v; };
      add(all, at(0, 0), at(1, 0), at(1, 1));
      add(all, at(0, 0), at(1, 1), at(0, 1));
    }
  }
}

void addNeedles(Input &in, Triangles &all) {
  const float width = in.number(), length = in.number();
  Spread random(in.byte());
  for (size_t n = in.byte() % 64; n > 0; --n) {
    const float x = random.unit(), y = random.unit(), z = random.unit(), s = random.unit();
    const Vec3 a(x, y, z), along = length * Vec3(y, z, s);
    add(all, a, a + along, a + along + width * Vec3(s, x, y));
  }
}

// Octahedra in octahedra.
void addShells(Input &in, Triangles &all) {
  const Vec3 centre = point(in);
  float size = in.number();
  const float factor = in.number();
  for (size_t n = in.byte() % 64; n > 0; --n, size *= factor) {
    for (int side = 0; side < 8; ++side) {
      const Vec3 x(side & 1 ? size : -size, 0, 0), y(0, side & 2 ? size : -size, 0), z(0, 0, side & 4 ? size : -size);
      add(all, centre + x, centre + y, centre + z);
    }
  }
}

void addSoup(Input &in, Triangles &all) {
  const uint32_t seed = in.byte();
  for (const HotTriangle &t : test::soup(in.byte(), seed)) add(all, t.v0, t.v1, t.v2);
}

constexpr void (*kShapes[])(Input &, Triangles &) = {addFree, addEqual, addGrid, addNeedles, addShells, addSoup};

// At corners, edges and middles of triangles, where a structure may lose them.
std::vector<Ray> raysAt(const Triangles &triangles, Input &in) {
  std::vector<Ray> rays;
  const auto send = [&](const Vec3 &from, const Vec3 &to) {
    const Vec3 way = to - from;
    const float length = glm::length(way);
    if (length > 0 && isFinite(way / length) && isFinite(from)) rays.push_back({from, way / length});
  };
  Spread random(in.byte());
  const float distance = in.number();
  for (size_t i = 0; i < 48; ++i) {
    const HotTriangle &t = triangles[random.next() % triangles.size()];
    const Vec3 targets[] = {t.v0, 0.5f * (t.v0 + t.v1), (t.v0 + t.v1 + t.v2) / 3.0f};
    const float x = random.unit(), y = random.unit(), z = random.unit();
    const Vec3 axis(i % 3 == 0, i % 3 == 1, i % 3 == 2);
    send(targets[i % 3] + distance * (i % 4 == 0 ? axis : Vec3(x, y, z)), targets[i % 3]);
  }
  for (int i = 0; i < 8; ++i) {
    const Vec3 from = point(in), to = point(in);
    send(from, to);
  }
  return rays;
}

struct Scene {
  Triangles triangles;
  std::vector<TriangleAttributes> attributes;
  ddk::Accel accel;

  SceneView view() {
    attributes.resize(triangles.size());
    SceneView view;
    view.geometry[0] = {triangles, attributes, {}, accel.view(), false};
    return view;
  }
};

// What a place, or one of two distances, may be off before it matters.
constexpr float kRounded = 10 * kSlack;

// Whether a hit lies where its triangle does. The distance to a needle can be rounded by more than the whole way to it;
// a structure then does not look where the hit is said to be.
bool isPlaced(const Hit &hit, const Ray &ray, const HotTriangle &t) {
  Bounds bounds;
  for (const Vec3 &v : {t.v0, t.v1, t.v2}) bounds.add(v);
  const Vec3 way = hit.t * ray.direction, place = ray.origin + way;
  const Vec3 margin = kRounded * (glm::abs(ray.origin) + glm::abs(way));
  return glm::all(glm::lessThanEqual(bounds.lower, place + margin)) &&
         glm::all(glm::lessThanEqual(place - margin, bounds.upper));
}

// Of two hits at nearly the same distance a structure may prefer the other one where the distance to a needle is
// rounded by more than the slack that boxes get. [rchal/units/traversal.h]
bool same(const Hit &found, const Hit &truth, const Ray &ray, const Scene &scene) {
  if (found.primitive == truth.primitive) return !found.found() || found.t == truth.t;
  if (!truth.found()) return false;
  if (!isPlaced(truth, ray, scene.triangles[truth.primitive])) return true;
  return found.found() && std::abs(found.t - truth.t) <= kRounded * truth.t;
}

// Says what differs, so that an ordinary test can be made of it.
void expectSame(const char *what, const Hit &found, const Hit &truth, const Ray &ray, const Scene &scene) {
  if (same(found, truth, ray, scene)) return;
  std::fprintf(stderr, "%s: primitive %d at %.9g, should be %d at %.9g\n", what, int(found.primitive), double(found.t),
               int(truth.primitive), double(truth.t));
  const auto print = [](const char *name, const Vec3 &v) {
    std::fprintf(stderr, "%s %.9g %.9g %.9g\n", name, double(v.x), double(v.y), double(v.z));
  };
  print("from", ray.origin);
  print("direction", ray.direction);
  for (const Hit &hit : {found, truth}) {
    if (!hit.found()) continue;
    const HotTriangle &t = scene.triangles[hit.primitive];
    for (const Vec3 &v : {t.v0, t.v1, t.v2}) print("vertex", v);
  }
  std::abort();
}

// Directions of 0 count as 1e-20 where boxes are met [rchal/units/traversal.h]: beyond some 1e13 times the size of a
// triangle's coordinates a box may be missed. Float cannot aim so far anyway.
bool meaningful(const Scene &scene, const std::vector<Ray> &rays) {
  constexpr float kFarthest = 1e12f;
  float largest = 0, smallest = kInf;
  const auto sizeOf = [](const Vec3 &v) { return maxComponent(glm::abs(v)); };
  for (const HotTriangle &t : scene.triangles) {
    const float size = std::max({sizeOf(t.v0), sizeOf(t.v1), sizeOf(t.v2)});
    largest = std::max(largest, size);
    smallest = std::min(smallest, size);
  }
  for (const Ray &ray : rays) largest = std::max(largest, sizeOf(ray.origin));
  return largest <= kFarthest && smallest >= 1 / kFarthest && largest <= kFarthest * smallest;
}

void compare(Scene &scene, const std::vector<Ray> &rays, const std::vector<Hit> &truth) {
  static const auto cpu = createDevice("cpu", 1);
  const SceneView view = scene.view();
  std::vector<Hit> hits(rays.size());
  cpu->intersect(view, rays, hits);
  if (!meaningful(scene, rays)) return;
  for (size_t i = 0; i < rays.size(); ++i) {
    expectSame("scalar", closestHit(view, rays[i]), truth[i], rays[i], scene);
    expectSame("cpu", hits[i], truth[i], rays[i], scene);
  }
}

std::vector<Hit> hitsOfAll(Scene &scene, const std::vector<Ray> &rays) {
  scene.accel = {};
  std::vector<Hit> hits;
  for (const Ray &ray : rays) hits.push_back(closestHit(scene.view(), ray));
  return hits;
}

void move(Triangles &triangles, Input &in) {
  const Vec3 by = point(in);
  const float scale = in.number();
  for (HotTriangle &t : triangles) {
    const HotTriangle moved = test::triangle(scale * t.v0 + by, scale * t.v1 + by, scale * t.v2 + by);
    if (usable(moved)) t = moved;
  }
}

}  // namespace

void run(Input in) {
  const Workers workers(1);
  Scene scene;
  for (size_t parts = 1 + in.below(6); parts > 0; --parts) in.oneOf(kShapes)(in, scene.triangles);
  if (scene.triangles.empty()) return;
  const std::vector<Ray> rays = raysAt(scene.triangles, in);
  const std::vector<Hit> truth = hitsOfAll(scene, rays);

  for (AccelKind kind : {AccelKind::KdTree, AccelKind::Bvh}) {
    scene.accel = ddk::buildAccel(kind, scene.triangles, workers);
    compare(scene, rays, truth);
  }
  ddk::Accel quick;
  quick.kind = AccelKind::Bvh;
  quick.triangles = scene.triangles.size();
  ddk::buildMorton(scene.triangles, workers, quick);
  quick.builtCost = ddk::costOf(quick);
  ddk::Accel built = std::exchange(scene.accel, std::move(quick));
  compare(scene, rays, truth);

  move(scene.triangles, in);
  const std::vector<Ray> others = raysAt(scene.triangles, in);
  const std::vector<Hit> moved = hitsOfAll(scene, others);
  ddk::refit(scene.triangles, workers, built);  // though it may advise a new tree, this one is whole
  scene.accel = std::move(built);
  compare(scene, others, moved);
}

}  // namespace rc::fuzz
