// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_cost.h: what finding the surface of each pixel costs, as numbers and as a picture.
#pragma once

#include <vector>

#include "draw/show.h"

namespace rc::tool {

// Tests, by pixel, the lowest row first.
struct RayCosts {
  int width = 0, height = 0;
  std::vector<float> boxes, triangles;
};

// Of the show's last picture.
RayCosts rayCosts(const Show &show);

double meanOf(const std::vector<float> &values);

// Boxes and triangles together, from dark to bright, with a legend below.
Image heatMap(const RayCosts &costs);

}  // namespace rc::tool
