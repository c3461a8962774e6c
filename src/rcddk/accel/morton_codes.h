// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// morton_codes.h: triangles in the order in which a space-filling curve goes through them.
#pragma once

#include <cstdint>
#include <span>

#include "base/bounds.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "rchal/scene_view.h"

namespace rc::ddk {

// A triangle, and where along the curve it lies: a bit of each axis in turns, highest first.
struct Coded {
  uint32_t code, primitive;
};

// By code, equal ones by number. core: where most triangles are, which the curve's cells divide.
LargeVector<Coded> sortedCodes(std::span<const hal::HotTriangle> triangles, const Bounds &core, const Workers &workers);

}  // namespace rc::ddk
