// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// picture_file.h: pictures to files, whole or not at all.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

// PNG, JPEG, BMP, PPM, OpenEXR by the name's extension. Throws UsageError: another extension;
// InputError: what writes it is not installed.
void checkPictureName(const std::string &name);

// Throws InputError: it is no folder.
void checkFolder(const std::string &name);

// Written beside the name and renamed; "-" is standard output, as PNG. Throws InputError.
void writePicture(const Image &image, const std::string &name);

// Whether the file is a picture of this size that can be read to its end.
bool isWholePicture(const std::string &name, int width, int height);

}  // namespace rc::tool
