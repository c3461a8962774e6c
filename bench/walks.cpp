// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Nodes and triangles that one ray after the other meets in our BVH of a static scene, by scene and kind of ray: how
// good the tree is, whatever the kernels make of it. scripts/embree_walks.py counts Embree's on the same rays.
#include <cstdio>

#include "peers/raycore.h"
#include "peers/rays.h"
#include "peers/report.h"
#include "rcddk/accel/builder.h"
#include "rchal/units/traversal.h"

namespace {

using namespace rc;
using namespace rc::bench;

struct Counts {
  size_t nodes = 0, leaves = 0, triangles = 0;
};

// A search that counts.
struct CountingSearch : hal::NearestSearch {
  Counts &counts;

  void inner(const hal::BvhNode8 &) { ++counts.nodes; }
  void inner(const hal::KdNode8 &) { ++counts.nodes; }
  bool operator()(std::span<const uint32_t> indices) {
    ++counts.leaves;
    counts.triangles += indices.size();
    return NearestSearch::operator()(indices);
  }
};

std::vector<FirstHit> walkAll(const hal::GeometryView &geometry, const RayBatch &rays, Counts &counts) {
  std::vector<FirstHit> hits;
  for (size_t i = 0; i < rays.size(); ++i) {
    const auto at = [&](int column) { return rays.column(column)[i]; };
    const hal::Ray ray{{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
    const hal::ShearedRay sheared(ray);
    const hal::HitOrder none;
    hal::Hit best;
    hal::walk(geometry, hal::TraversalRay(ray), best.t,
              CountingSearch{{geometry.triangles, sheared, 0, none, best}, counts});
    hits.push_back({best.t, best.found() ? best.primitive : kMiss});
  }
  return hits;
}

void report(const Soup &soup, Kind kind, const RayBatch &rays, const Counts &counts) {
  const auto each = [&](size_t count) { return double(count) / double(rays.size()); };
  std::printf("| %s | %s | %zu | %.2f | %.2f | %.2f |\n", soup.name.c_str(), kKindNames[kind], rays.size(),
              each(counts.nodes), each(counts.leaves), each(counts.triangles));
  std::fflush(stdout);
}

void measureScene(const Soup &soup, std::pair<int, int> size) {
  const std::vector<hal::HotTriangle> triangles = trianglesOf(soup);
  const ddk::Accel accel = ddk::buildAccel(AccelKind::Bvh, triangles, Workers(2), ddk::Lifetime::Scene);
  const hal::GeometryView geometry{triangles, {}, {}, accel.view(), false};
  const RayBatch primary = primaryRays(soup, size.first, size.second);
  Counts counts;
  const std::vector<FirstHit> hits = walkAll(geometry, primary, counts);
  report(soup, kPrimary, primary, counts);
  for (const Kind kind : {kMirror, kDiffuse}) {
    const RayBatch rays = secondaryRays(soup, kind, primary, hits);
    Counts secondary;
    walkAll(geometry, rays, secondary);
    report(soup, kind, rays, secondary);
  }
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments arguments = readArguments(argc, argv);
  std::printf("| scene | rays | number | nodes of eight a ray | leaves | triangles |\n|---|---|---:|---:|---:|---:|\n");
  for (const std::string &name : arguments.names) {
    const std::optional<Soup> soup = loadSoup(name, arguments.scenes);
    if (soup) {
      measureScene(*soup, arguments.sizes[0]);
    } else {
      std::printf("%s: skipped, its file is not in %s\n", name.c_str(), arguments.scenes.c_str());
    }
  }
}
