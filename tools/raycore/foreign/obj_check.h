// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// obj_check.h: what Assimp's OBJ reader takes without a word, or leaves out: indices beyond the vertices, vertices
// that are cut short.
#pragma once

#include <string_view>

#include "scene/scene.h"

namespace rc::tool::foreign {

// Rejects with the line; notes what is only odd.
void checkObj(std::string_view text, Scene &scene);

}  // namespace rc::tool::foreign
