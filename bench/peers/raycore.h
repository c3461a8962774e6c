// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore.h: a soup as the triangles that our structures are built of.
#pragma once

#include <vector>

#include "peers/soup.h"
#include "rchal/scene_view.h"

namespace rc::bench {

std::vector<hal::HotTriangle> trianglesOf(const Soup &soup);

}  // namespace rc::bench
