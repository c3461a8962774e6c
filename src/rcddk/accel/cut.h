// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// cut.h: the parts of a triangle on both sides of a plane, as boxes.
// Havran, Bittner: "On Improving KD-Trees for Ray Shooting", WSCG 2002, call it split clipping.
#pragma once

#include "rcddk/accel/builder.h"

namespace rc::ddk {

// Widened by boxMargin(), so they reach a little beyond the plane; empty where the triangle has no part in the old box.
struct CutBoxes {
  Bounds below, above;
};

// box: of the part of the triangle that is cut, widened.
CutBoxes cut(const hal::HotTriangle &triangle, const Bounds &box, int axis, float position);

}  // namespace rc::ddk
