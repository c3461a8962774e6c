// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// sample.cpp: what most triangles are like, by a sample of them. It says what rays meet better than the bounds do: a
// figure may stand on a floor that reaches to the horizon.
#include <algorithm>

#include "rcddk/accel/builder.h"

namespace rc::ddk {

using hal::HotTriangle;

namespace {

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

void sampleTriangles(std::span<const HotTriangle> triangles, Accel &accel) {
  Sample sample(triangles);
  accel.core = sample.core();
  accel.grain = sample.grain();
}

}  // namespace rc::ddk
