// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// capture.h: RAYCORE_CAPTURE writes each shown picture to a file. [spec 6]
#pragma once

#include <string>

#include "rchal/device.h"

namespace rc::egl {

// The file name of frame n: the first %d or %0Nd of the pattern becomes the number, everything else stays.
std::string captureName(const std::string &pattern, int frame);

// Writes PNG, or PPM for names that end in .ppm. The file appears when it is complete. On failure a message
// says what, where and why, and the rest goes on.
bool writePicture(const std::string &name, const hal::Target &picture);

}  // namespace rc::egl
