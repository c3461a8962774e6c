// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A million random rays on each of three meshes: every structure gives the same hits as trying all triangles.
#include "common/hits.h"

namespace rc::test {
namespace {

constexpr size_t kMillion = 1000000;

TEST(AccelMillion, KnotOf2048) { compareAll(knot(32), kMillion); }
TEST(AccelMillion, SoupOf500) { compareAll(soup(500, 3), kMillion); }
TEST(AccelMillion, TerrainOf51200) { compareAll(terrain(160), kMillion); }

}  // namespace
}  // namespace rc::test
