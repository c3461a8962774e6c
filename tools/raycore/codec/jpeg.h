// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// jpeg.h: JPEG, by libjpeg, which starts at once.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace rc::tool {

// name: for messages. Nothing: neither grey nor of three colours, which is the codec's. Throws InputError.
std::optional<Image> decodeJpeg(const std::string &bytes, const std::string &name);

// The bytes of a file, without opacity. Throws InputError.
std::string encodeJpeg(const Image &image);

}  // namespace rc::tool
