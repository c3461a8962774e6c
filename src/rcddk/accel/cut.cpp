// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/accel/cut.h"

namespace rc::ddk {
namespace {

Bounds widened(Bounds part, float margin, const Bounds &box) {
  // Only the widened box crosses the plane: keep the sliver.
  if (part.empty()) part = box;
  part.lower -= margin;
  part.upper += margin;
  return intersection(part, box);
}

}  // namespace

CutBoxes cut(const hal::HotTriangle &triangle, const Bounds &box, int axis, float position) {
  const Vec3 vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
  Bounds below, above;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = vertices[i], &b = vertices[(i + 1) % 3];
    const float da = a[axis] - position, db = b[axis] - position;
    if (da <= 0) below.add(a);
    if (da >= 0) above.add(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
      const Vec3 crossing = glm::mix(a, b, std::clamp(da / (da - db), 0.0f, 1.0f));
      below.add(crossing);
      above.add(crossing);
    }
  }
  const float margin = boxMargin(triangle);
  return {widened(below, margin, box), widened(above, margin, box)};
}

}  // namespace rc::ddk
