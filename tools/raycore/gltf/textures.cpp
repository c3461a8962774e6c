// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <optional>

#include "codec/picture.h"
#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

Wrap wrapOf(const Value &token) {
  switch (token.count(10497)) {
    case 33071:
      return Wrap::Clamp;
    case 33648:
      return Wrap::Mirror;
    case 10497:
      return Wrap::Repeat;
  }
  token.complain("is no wrap mode");
}

// A picture that is missing or damaged costs its texture, not the model.
Image readImage(Document &document, const Value &about, size_t index) {
  const std::string name = about["name"].text(about["uri"] ? "" : fmt::format("image {}", index));
  try {
    if (about["uri"]) {
      const std::string uri = about["uri"].text();
      const bool isFile = !uri.starts_with("data:");
      return decodePicture(fetch(about["uri"], document.folder()), isFile ? uri : name);
    }
    const Value view = about.at("bufferView");
    return decodePicture(std::string(document.view(view.index(document.countOf("bufferViews"))).bytes), name);
  } catch (const InputError &error) {
    const std::string what = error.what();
    const bool placed = what.starts_with(about.place());
    document.scene.note(fmt::format("{}{}; drawn without this texture", placed ? "" : about.place() + ": ", what));
    return {name, 0, 0, {}};
  }
}

}  // namespace

void readTextures(Document &document) {
  const Value images = document["images"], textures = document["textures"], samplers = document["samplers"];
  for (size_t i = 0; i < images.size(); ++i) document.scene.images.push_back(readImage(document, images[i], i));
  for (size_t i = 0; i < textures.size(); ++i) {
    Texture texture{textures[i]["source"].index(images.size())};
    if (texture.image < 0) document.scene.note(textures[i].place() + ": has no picture in a format of glTF 2.0");
    const int sampler = textures[i]["sampler"].index(samplers.size());
    if (sampler >= 0) {
      const Value about = samplers[size_t(sampler)];
      texture.wrapS = wrapOf(about["wrapS"]);
      texture.wrapT = wrapOf(about["wrapT"]);
      if (about["magFilter"].count(9729) == 9728)
        document.scene.note("nearest filtering: textures are always filtered");
    }
    document.scene.textures.push_back(texture);
  }
}

}  // namespace rc::tool::gltf
