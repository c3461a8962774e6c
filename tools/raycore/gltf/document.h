// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// document.h: a glTF file that is being read: its JSON, its buffers, the scene that grows from it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/container.h"
#include "scene/scene.h"

namespace rc::tool::gltf {

// Bytes of a data: URI, or of a file beside the model; never of another folder and never from a network.
std::string fetch(const Value &uri, const std::string &folder);

class Document {
 public:
  Document(std::string_view bytes, std::string folder);

  Value root() const { return {mContainer.json.get(), {}}; }
  Value operator[](const char *key) const { return root()[key]; }
  size_t countOf(const char *array) const { return root()[array].size(); }
  const std::string &folder() const { return mFolder; }

  struct View {
    std::string_view bytes;
    size_t stride;  // 0: packed
  };
  // A bufferView, checked against its buffer.
  View view(int index);

  Scene scene;

 private:
  std::string_view buffer(int index);

  Container mContainer;
  std::string mFolder;
  std::map<int, std::string> mFetched;
};

}  // namespace rc::tool::gltf
