// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// hits RAYS [scene ...]: so many random, coherent, grazing, axis-parallel and edge-on rays through models, on each
// structure and instruction set; how many hits differ in any bit from those of the scalar unit. Through the other
// structure that must find the same. RAYCORE_SCENES names the folder of scenes. Ends with code 1 if a hit differs.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "common/ray_columns.h"
#include "common/ray_kinds.h"
#include "peers/soup.h"
#include "rchal/units/traversal.h"

namespace {

using namespace rc;

// The box [-1, 1], where rays look for it.
std::vector<Vec3> fitted(std::vector<Vec3> vertices) {
  Bounds bounds;
  for (const Vec3 &v : vertices) bounds.add(v);
  const Vec3 centre = 0.5f * (bounds.lower + bounds.upper);
  const float scale = 2 / maxComponent(bounds.size());
  for (Vec3 &v : vertices) v = (v - centre) * scale;
  return vertices;
}

struct Count {
  size_t rays = 0, different = 0;

  void add(std::span<const hal::Hit> hits, std::span<const hal::Hit> truth) {
    rays += hits.size();
    for (size_t i = 0; i < hits.size(); ++i) {
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the last bit
      different += std::memcmp(&hits[i], &truth[i], sizeof(hal::Hit)) != 0;
    }
  }
};
using Counts = std::map<std::string, Count>;

void scalarHits(const hal::SceneView &scene, std::span<const hal::Ray> rays, std::span<hal::Hit> hits) {
  for (size_t i = 0; i < rays.size(); ++i) hits[i] = hal::closestHit(scene, rays[i]);
}

void compareTargets(const char *structure, const hal::SceneView &scene, const test::Columns &columns,
                    std::span<const hal::Hit> truth, Counts &counts) {
  test::forEachTarget([&](const char *name) {
    counts[std::string(structure) + ", " + name].add(test::closestHits(scene, columns), truth);
  });
}

size_t compare(const bench::Soup &soup, size_t wanted) {
  const test::Triangles triangles = test::trianglesOf(fitted(soup.vertices));
  test::TestScene bvh(triangles), kdTree(triangles, AccelKind::KdTree);
  const hal::SceneView &bvhView = bvh.update(), &kdView = kdTree.update();
  Counts counts;
  for (const test::RayKind kind : test::kAllRayKinds) {
    const std::vector<hal::Ray> rays = test::raysOf(kind, wanted / std::size(test::kAllRayKinds), bvhView);
    const test::Columns columns(rays);
    std::vector<hal::Hit> truth(rays.size()), hits(rays.size());
    scalarHits(bvhView, rays, truth);
    scalarHits(kdView, rays, hits);
    counts["KD-tree, scalar"].add(hits, truth);
    compareTargets("BVH", bvhView, columns, truth, counts);
    compareTargets("KD-tree", kdView, columns, truth, counts);
  }
  size_t different = 0;
  for (const auto &[what, count] : counts) {
    std::printf("%-10s %-18s %12zu rays %zu differ\n", soup.name.c_str(), what.c_str(), count.rays, count.different);
    different += count.different;
  }
  std::fflush(stdout);
  return different;
}

}  // namespace

int main(int argc, char **argv) {
  const size_t wanted = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const char *folder = std::getenv("RAYCORE_SCENES");
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"cornell", "bunny", "sponza", "dragon203k", "dragon871k"};
  size_t different = 0;
  for (const std::string &name : names) {
    const auto soup = rc::bench::loadSoup(name, folder ? folder : "../shared/scenes");
    if (soup) {
      different += compare(*soup, wanted);
    } else {
      std::printf("%s: skipped, its file is not there\n", name.c_str());
    }
  }
  return different == 0 ? 0 : 1;
}
