// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shape.h: a structure in numbers, for those who ask what it is like. [RC_RCX_frame_statistics]
#pragma once

#include "rcddk/accel/builder.h"

namespace rc::ddk {

struct AccelShape {
  size_t nodes = 0;  // inner ones
  size_t leaves = 0;
  int depth = 0;    // nodes on the longest way from the root to a leaf, the leaf included
  double cost = 0;  // boxes that a random line through the bounds meets [Goldsmith, Salmon 1987]
};

AccelShape shapeOf(const Accel &accel);

}  // namespace rc::ddk
