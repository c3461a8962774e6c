// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// read.h: models in every format but glTF, by Assimp.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool::foreign {

bool reads(const std::string &extension);
Scene readFile(const std::string &name);

}  // namespace rc::tool::foreign
