// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// picture.h: bytes of a picture file -> RGBA, in any format that its first bytes tell.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

// name: for messages, and for the format where the bytes do not tell. Throws InputError.
Image decodePicture(const std::string &bytes, const std::string &name);

}  // namespace rc::tool
