// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// jpeg.h: JPEG, by libjpeg, which starts at once.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace rc::tool {

// name: for messages. Nothing: four colours of printers, which are the codec's. Throws InputError.
std::optional<Image> decodeJpeg(const std::string &bytes, const std::string &name);

}  // namespace rc::tool
