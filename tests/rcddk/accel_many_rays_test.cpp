// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Many random rays on each of three meshes: every structure gives the same hits as trying all triangles, which is what
// takes long. With RAYCORE_TEST_RAYS=1000000 it is a million each, for minutes.
#include "common/hits.h"
#include "common/on_each_target.h"

namespace rc::test {
namespace {

TEST(AccelManyRays, KnotOf2048) { compareAll(knot(32), raysFromEnvironment(100000)); }
TEST(AccelManyRays, SoupOf500) { compareAll(soup(500, 3), raysFromEnvironment(200000)); }
TEST(AccelManyRays, TerrainOf51200) { compareAll(terrain(160), raysFromEnvironment(10000)); }

}  // namespace
}  // namespace rc::test
