// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/builder.h"

namespace rc::ddk {

using hal::HotTriangle;

float boxMargin(const HotTriangle &triangle) {
  return std::max(hal::largestCoordinate(triangle.v0, triangle.v1, triangle.v2) * kMarginShare, kLeastMargin);
}

Array<Reference> makeReferences(std::span<const HotTriangle> triangles, Bounds &all) {
  Array<Reference> references(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    Reference &reference = references[i];
    reference.primitive = static_cast<uint32_t>(i);
    for (const Vec3 &v : {triangles[i].v0, triangles[i].v1, triangles[i].v2}) reference.box.add(v);
    const float margin = boxMargin(triangles[i]);
    reference.box.lower -= margin;
    reference.box.upper += margin;
    all.add(reference.box);
  }
  return references;
}

// So few triangles are sorted by the surface area heuristic within a millisecond or two.
constexpr size_t kFewTriangles = 8192;

Accel buildAccel(AccelKind kind, std::span<const HotTriangle> triangles, const Workers &workers, Lifetime lifetime,
                 Accel old) {
  Accel accel;
  accel.kind = kind;
  accel.triangles = triangles.size();
  if (triangles.empty()) return accel;
  if (kind == AccelKind::Bvh) {  // what is there is written over
    accel.bvhNodes = std::move(old.bvhNodes);
    accel.blocks = std::move(old.blocks);
  }
  sampleTriangles(triangles, accel);
  if (kind == AccelKind::KdTree) workers.run([&] { buildKdTree(triangles, accel); });
  if (kind == AccelKind::Bvh) {
    if (lifetime == Lifetime::Frame && triangles.size() > kFewTriangles) {
      buildMorton(triangles, workers, accel);
    } else {
      workers.run([&] { buildBvh(triangles, lifetime, accel); });
    }
  }
  if (kind == AccelKind::Bvh) accel.builtCost = costOf(accel);
  return accel;
}

}  // namespace rc::ddk
