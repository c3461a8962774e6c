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

void buildBvh(std::span<const hal::HotTriangle> triangles, Accel &accel) {
  std::vector<BuildReference> references = makeBuildReferences(triangles, accel.bounds);
  BvhPieces pieces;
  HWY_DYNAMIC_DISPATCH(buildPieces)(references, triangles, accel.bounds, pieces);
  accel.bvhNodes = std::move(pieces.nodes);
  accel.blocks = std::move(pieces.blocks);
}

}  // namespace rc::ddk
#endif
