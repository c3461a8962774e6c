// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// leaks RAYS [scene ...]: so many rays at the edges and vertices of scanned meshes, on each structure and instruction
// set; how many of them pass. RAYCORE_SCENES names the folder of scenes. Ends with code 1 if one does.
#include <cstdio>
#include <cstdlib>

#include "common/edge_rays.h"
#include "common/ray_columns.h"
#include "peers/soup.h"
#include "rchal/units/traversal.h"

namespace {

using namespace rc;

constexpr size_t kPart = 65536;

struct Part {
  std::vector<test::EdgeRays::AimedRay> aimed;
  std::vector<hal::Ray> rays;
  std::vector<hal::Hit> hits;

  explicit Part(test::EdgeRays &source) : aimed(source.some(kPart)), hits(aimed.size()) {
    for (const auto &[ray, latest] : aimed) rays.push_back(ray);
  }
  size_t leaks() const {
    size_t count = 0;
    for (size_t i = 0; i < hits.size(); ++i) count += !test::EdgeRays::stopped(aimed[i], hits[i]);
    return count;
  }
};

struct Count {
  std::string what;
  size_t rays = 0, leaks = 0;

  void add(const Part &part) {
    rays += part.rays.size();
    leaks += part.leaks();
  }
};

// All instruction sets for each part: what takes the time is to find the rays.
size_t shoot(const bench::Soup &soup, size_t wanted) {
  const test::Triangles triangles = test::trianglesOf(soup.vertices);
  test::TestScene bvh(triangles), kdTree(triangles, AccelKind::KdTree);
  const auto device = hal::createDevice("cpu", 1);
  std::vector<Count> counts{{"KD-tree, cpu"}, {"BVH, scalar"}};
  test::forEachTarget([&](const char *name) { counts.push_back({std::string("BVH, ") + name}); });
  const hal::SceneView &bvhView = bvh.update(), &kdView = kdTree.update();
  test::EdgeRays source(triangles, 1);
  for (size_t done = 0; done * counts.size() < wanted; done += kPart) {
    Part part(source);
    const test::Columns columns(part.rays);
    device->intersect(kdView, part.rays, part.hits);
    counts[0].add(part);
    for (size_t i = 0; i < part.rays.size(); ++i) part.hits[i] = hal::closestHit(bvhView, part.rays[i]);
    counts[1].add(part);
    size_t next = 2;
    test::forEachTarget([&](const char *) {
      part.hits = test::closestHits(bvhView, columns);
      counts[next++].add(part);
    });
  }
  size_t leaks = 0;
  for (const Count &count : counts) {
    std::printf("%-10s %-16s %12zu rays %zu leaks\n", soup.name.c_str(), count.what.c_str(), count.rays, count.leaks);
    leaks += count.leaks;
  }
  std::fflush(stdout);
  return leaks;
}

}  // namespace

int main(int argc, char **argv) {
  const size_t wanted = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const char *folder = std::getenv("RAYCORE_SCENES");
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"bunny", "dragon203k", "dragon871k", "hills100000"};
  size_t leaks = 0;
  for (const std::string &name : names) {
    const auto soup = rc::bench::loadSoup(name, folder ? folder : "../shared/scenes");
    if (soup) {
      leaks += shoot(*soup, wanted);
    } else {
      std::printf("%s: skipped, its file is not there\n", name.c_str());
    }
  }
  return leaks == 0 ? 0 : 1;
}
