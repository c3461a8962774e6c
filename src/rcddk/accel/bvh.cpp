// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bvh.cpp: the BVH's builder for each instruction set, and the choice among them.
#include "base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rcddk/accel/bvh.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "rcddk/accel/bvh_build-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddk::HWY_NAMESPACE {

void buildPieces(std::span<BuildReference> references, std::span<const hal::HotTriangle> triangles, const Bounds &all,
                 BvhPieces &out) {
  Builder(references, triangles).build(all, out);
}

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rc::ddk {

HWY_EXPORT(buildPieces);

// Parts of triangles that a tree may hold beyond one reference for each.
constexpr double kMostParts = 0.3;

void buildBvh(std::span<const hal::HotTriangle> triangles, Lifetime lifetime, Accel &accel) {
  Array<BuildReference> references = makeBuildReferences(triangles, accel.bounds);
  const double room = lifetime == Lifetime::Scene ? kMostParts : 0;
  references.resize(triangles.size() + static_cast<size_t>(room * static_cast<double>(triangles.size())));
  BvhPieces pieces;
  HWY_DYNAMIC_DISPATCH(buildPieces)(references, triangles, accel.bounds, pieces);
  accel.bvhNodes = std::move(pieces.nodes);
  accel.blocks = std::move(pieces.blocks);
}

}  // namespace rc::ddk
#endif
