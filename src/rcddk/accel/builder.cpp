// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/builder.h"

#include <algorithm>

namespace rc::ddk {

using hal::HotTriangle;

float boxMargin(const HotTriangle &triangle) {
  const Vec3 largest = glm::max(glm::abs(triangle.v0), glm::max(glm::abs(triangle.v1), glm::abs(triangle.v2)));
  return std::max(maxComponent(largest) * kMarginShare, kLeastMargin);
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

namespace {

// Statistics of a sample of the triangles, which say what rays meet better than the bounds do: a figure may stand on a
// floor that reaches to the horizon.
class Sample {
 public:
  explicit Sample(std::span<const HotTriangle> triangles) {
    const size_t step = triangles.size() / kMost + 1;
    for (size_t i = 0; i < triangles.size(); i += step) {
      Bounds &box = mBoxes[mCount++];
      for (const Vec3 &v : {triangles[i].v0, triangles[i].v1, triangles[i].v2}) box.add(v);
    }
  }

  float grain() {
    return valueAt(0.5f, [](const Bounds &box) { return maxComponent(box.size()); });
  }
  Bounds core() {
    Bounds out;
    for (int axis = 0; axis < 3; ++axis) {
      out.lower[axis] = valueAt(kFew, [axis](const Bounds &box) { return box.lower[axis]; });
      out.upper[axis] = valueAt(1 - kFew, [axis](const Bounds &box) { return box.upper[axis]; });
    }
    return out;
  }

 private:
  static constexpr size_t kMost = 511;
  static constexpr float kFew = 0.03f;  // share of triangles that lie outside, on each side

  // The value with that share of the others below it.
  template <class Value>
  float valueAt(float share, Value &&value) {
    for (size_t i = 0; i < mCount; ++i) mValues[i] = value(mBoxes[i]);
    float *const at = mValues + std::min(size_t(share * float(mCount)), mCount - 1);
    std::nth_element(mValues, at, mValues + mCount);
    return *at;
  }

  size_t mCount = 0;
  Bounds mBoxes[kMost + 1];
  float mValues[kMost + 1];
};

}  // namespace

// So few triangles are sorted by the surface area heuristic within a millisecond or two.
constexpr size_t kFewTriangles = 8192;

Accel buildAccel(AccelKind kind, std::span<const HotTriangle> triangles, const Workers &workers, Lifetime lifetime,
                 Accel old) {
  Accel accel;
  accel.bvhNodes = std::move(old.bvhNodes);
  accel.blocks = std::move(old.blocks);
  accel.bvhNodes.clear();
  accel.blocks.clear();
  accel.kind = kind;
  accel.triangles = triangles.size();
  if (triangles.empty()) return accel;
  Sample sample(triangles);
  accel.core = sample.core();
  accel.grain = sample.grain();
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
