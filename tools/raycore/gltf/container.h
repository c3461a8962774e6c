// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// container.h: a .glb or .gltf file -> its JSON and its binary chunk. [glTF 2.0, 4]
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gltf/json.h"

namespace rc::tool::gltf {

struct Container {
  std::shared_ptr<const Json> json;
  std::optional<std::string_view> binary;  // within the file's bytes
};

bool isBinary(std::string_view bytes);
Container open(std::string_view bytes);

}  // namespace rc::tool::gltf
