// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Lists of what shadow rays cross: in order, each triangle once, with an end.
#include "rcddi/cpu/filter_hits.h"

#include <gtest/gtest.h>

#include "common/meshes.h"
#include "common/on_each_target.h"

namespace rc::test {
namespace {

using namespace rc::hal;
using ddi::cpu::FilterHits;

std::vector<uint32_t> primitivesOf(const FilterHits &filters, size_t ray) {
  std::vector<uint32_t> out;
  filters.forEach(ray, [&](const Hit &hit) {
    out.push_back(hit.primitive);
    return true;
  });
  return out;
}

TEST(FilterHits, AreInOrderByDistanceThenByNumber) {
  FilterHits filters;
  filters.reset(2);
  filters.note(1, {3, 0, 0, 7});
  filters.note(1, {1, 0, 0, 9});
  filters.note(1, {2, 0, 0, 5});
  filters.note(1, {2, 0, 0, 4});
  EXPECT_EQ(primitivesOf(filters, 1), (std::vector<uint32_t>{9, 4, 5, 7}));
  EXPECT_FALSE(filters.meetsAny(0));
  EXPECT_TRUE(filters.meetsAny(1));
}

TEST(FilterHits, HaveEachTriangleOnce) {
  FilterHits filters;
  filters.reset(1);
  for (const uint32_t primitive : {2, 1, 2, 1, 3, 3}) filters.note(0, {float(primitive), 0, 0, primitive});
  EXPECT_EQ(primitivesOf(filters, 0), (std::vector<uint32_t>{1, 2, 3}));
}

TEST(FilterHits, EndWhenTheyAreAsked) {
  FilterHits filters;
  filters.reset(1);
  for (uint32_t i = 0; i < 5; ++i) filters.note(0, {float(i), 0, 0, i});
  int seen = 0;
  filters.forEach(0, [&](const Hit &) { return ++seen < 3; });
  EXPECT_EQ(seen, 3);
}

TEST(FilterHits, OfARayWithTooManyAreNotKept) {
  FilterHits filters;
  filters.reset(1);
  for (uint32_t i = 0; i < FilterHits::kMost; ++i) EXPECT_TRUE(filters.note(0, {float(100 - i), 0, 0, i}));
  EXPECT_FALSE(filters.hasTooMany(0));
  EXPECT_FALSE(filters.note(0, {0.5f, 0, 0, 999}));
  EXPECT_TRUE(filters.hasTooMany(0));
  EXPECT_FALSE(filters.note(0, {0.25f, 0, 0, 1000})) << "and stay so";
}

// More panes of glass than a list holds: the ray is said to need the scalar unit, and another one, which an opaque wall
// stops, is blocked.
TEST(FilterHits, OfManyPanes) {
  Triangles triangles;
  for (int i = 0; i < FilterHits::kMost + 8; ++i) {
    const float z = 1 + 0.1f * float(i);
    triangles.push_back(triangle({-1, -1, z}, {1, -1, z}, {0, 2, z}, 0, kTransmittanceShadow));
  }
  triangles.push_back(triangle({9, -1, 0.5f}, {11, -1, 0.5f}, {10, 2, 0.5f}));
  for (const AccelKind kind : {AccelKind::Bvh, AccelKind::KdTree}) {
    TestScene scene(triangles, kind);
    const SceneView &view = scene.update();
    const Ray rays[] = {{{0, 0, 0}, {0, 0, 1}}, {{10, 0, 0}, {0, 0, 1}}, {{0, 0, 3.95f}, {0, 0, 1}}};
    const Columns columns(rays);
    onEachTarget([&] {
      FilterHits filters;
      filters.reset(3);
      ddi::cpu::RayStream stream = columns.stream();
      stream.reach.end = 100;
      uint8_t blocked[3];
      ddi::cpu::findBlocked(view, stream, blocked, &filters);
      EXPECT_TRUE(filters.hasTooMany(0));
      EXPECT_EQ(blocked[1], 1);
      EXPECT_FALSE(filters.meetsAny(1));
      EXPECT_EQ(blocked[2], 0);
      EXPECT_EQ(primitivesOf(filters, 2).size(), size_t(2));
    });
  }
}

}  // namespace
}  // namespace rc::test
