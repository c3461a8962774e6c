// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: clip planes. A plane goes through the world: the modelview matrix of its call takes it there.
// [spec 3.8; OpenGL ES 1.1, 2.11]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

// The plane of a token, or an error and null.
Vec4 *findPlane(Context &context, RCenum name) {
  const RCenum index = name - RC_CLIP_PLANE0;
  if (index < ClipState::kPlanes) return &context.state.clip.planes[index];
  context.fail(RC_INVALID_ENUM, "plane 0x%04X is not RC_CLIP_PLANE0 ... %zu", name, ClipState::kPlanes - 1);
  return nullptr;
}

void setPlane(Context &context, RCenum name, bool hasValues, const Vec4 &equation) {
  Vec4 *plane = findPlane(context, name);
  if (!plane || !hasValues) return;
  // A row vector times the inverse matrix; without an inverse the plane is where it was given.
  const Mat4 &worldFromObject = context.state.matrices.modelview.current();
  const bool invertible = std::abs(glm::determinant(worldFromObject)) > 0;
  *plane = invertible ? equation * glm::inverse(worldFromObject) : equation;
}

}  // namespace

extern "C" {

void rcClipPlanef(RCenum plane, const RCfloat *equation) {
  enter(Call("rcClipPlanef", plane, list(equation, 4)), [&](Context &c) {
    setPlane(c, plane, equation != nullptr,
             equation ? Vec4(equation[0], equation[1], equation[2], equation[3]) : Vec4(0));
  });
}

void rcClipPlanex(RCenum plane, const RCfixed *equation) {
  enter(Call("rcClipPlanex", plane, list(equation, 4)), [&](Context &c) {
    Vec4 values(0);
    for (int i = 0; equation && i < 4; ++i) values[i] = fromFixed(equation[i]);
    setPlane(c, plane, equation != nullptr, values);
  });
}

void rcGetClipPlanef(RCenum pname, RCfloat eqn[4]) {
  enter(Call("rcGetClipPlanef", pname, eqn), [&](Context &c) {
    const Vec4 *plane = findPlane(c, pname);
    for (int i = 0; plane && eqn && i < 4; ++i) eqn[i] = (*plane)[i];
  });
}

void rcGetClipPlanex(RCenum pname, RCfixed eqn[4]) {
  enter(Call("rcGetClipPlanex", pname, eqn), [&](Context &c) {
    const Vec4 *plane = findPlane(c, pname);
    for (int i = 0; plane && eqn && i < 4; ++i) eqn[i] = toFixed(double((*plane)[i]));
  });
}

}  // extern "C"
