// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// png.h: the format in which nearly all pictures are written, by libpng, which RayCore needs anyway and which starts
// at once; the others are the codec's.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

// Without opacity. name: for messages. Throws InputError.
void writePng(const Image &image, const std::string &file, const std::string &name);

// Whether the file is a picture of this size that can be read to its end.
bool isWholePng(const std::string &file, int width, int height);

}  // namespace rc::tool
