// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// obj_check.h: what Assimp's OBJ reader takes without a word, or leaves out: indices beyond the vertices, vertices
// that are cut short, materials that are not there.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace rc::tool::foreign {

// Whether a file that the model names can be opened.
using FileExists = std::function<bool(const std::string &name)>;

// Rejects with the line; notes what is only odd.
void checkObj(std::string_view text, const FileExists &exists, Scene &scene);

}  // namespace rc::tool::foreign
