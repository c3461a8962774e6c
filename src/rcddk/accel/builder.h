// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// builder.h: triangles to an acceleration structure. [G 1.2a]
// Both kinds are complete and deterministic: the same triangles give the same tree on any number of threads.
#pragma once

#include "base/large_pages.h"
#include "base/parallel.h"
#include "rchal/scene_view.h"

namespace rc::ddk {

struct Accel {
  AccelKind kind = AccelKind::Exhaustive;
  Bounds bounds;
  Bounds core;  // this and grain as in hal::AccelView
  float grain = 0;
  size_t triangles = 0;
  double builtCost = 0;  // BVH: costOf() when it was built
  Array<hal::KdNode8> kdNodes;
  Array<uint32_t> primitives;
  LargeVector<hal::BvhNode8> bvhNodes;
  LargeVector<hal::TriangleBlock4> blocks;

  hal::AccelView view() const { return {kind, bounds, core, grain, kdNodes, primitives, bvhNodes, blocks}; }
  size_t bytes() const {
    return kdNodes.size() * sizeof(hal::KdNode8) + primitives.size() * sizeof(uint32_t) +
           bvhNodes.size() * sizeof(hal::BvhNode8) + blocks.size() * sizeof(hal::TriangleBlock4);
  }
};

// How long a structure is of use: many frames, or the next one only, where a quick build counts as much as its rays.
enum class Lifetime { Scene, Frame };

// Triangles must be finite. The memory of `old` is used again.
Accel buildAccel(AccelKind kind, std::span<const hal::HotTriangle> triangles, const Workers &workers,
                 Lifetime lifetime = Lifetime::Scene, Accel old = {});

// Fits a BVH to triangles that have moved since it was built, as many as then. False if there is none for so many, or
// if it has become so much worse that it should be built anew; then what it is is undefined.
bool refit(std::span<const hal::HotTriangle> triangles, const Workers &workers, Accel &accel);

// The core and the grain of triangles as they lie now; at least one.
void sampleTriangles(std::span<const hal::HotTriangle> triangles, Accel &accel);

// What a random ray through the core costs in a BVH: boxes it meets there. One triangle far away makes the bounds as
// large as it likes, and any tree good by that measure. [Goldsmith, Salmon 1987]
double costOf(const Accel &accel);

// One for each kind, and one for a frame's BVH; buildAccel chooses.
void buildKdTree(std::span<const hal::HotTriangle> triangles, Accel &accel);
void buildBvh(std::span<const hal::HotTriangle> triangles, Lifetime lifetime, Accel &accel);
void buildMorton(std::span<const hal::HotTriangle> triangles, const Workers &workers, Accel &accel);

// A triangle, or the part of it that lies in a cell, on its way through a builder.
struct Reference {
  Bounds box;
  uint32_t primitive = 0;
};

// How far the box of a triangle is widened, so that no ray which the intersection unit lets hit the triangle
// can miss its box by rounding.
float boxMargin(const hal::HotTriangle &triangle);
inline constexpr float kMarginShare = 0x1p-21f, kLeastMargin = 1e-36f;  // of the largest coordinate; at least

// One for each triangle, widened; accel.bounds becomes their union.
Array<Reference> makeReferences(std::span<const hal::HotTriangle> triangles, Bounds &all);

// Subtrees with at least so many references are built at the same time as their siblings.
inline constexpr size_t kParallelReferences = 8192;

}  // namespace rc::ddk
