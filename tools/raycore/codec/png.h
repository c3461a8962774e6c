// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// png.h: PNG, by libpng, which RayCore needs anyway and which starts at once.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

// Of any kind of PNG; 16 bits are rounded to 8. name: for messages. Throws InputError.
Image decodePng(const std::string &bytes, const std::string &name);

// Without opacity. name: for messages. Throws InputError.
void writePng(const Image &image, const std::string &file, const std::string &name);

// Whether the file is a picture of this size that can be read to its end.
bool isWholePng(const std::string &file, int width, int height);

}  // namespace rc::tool
