// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The whole of a glTF file. Our own reader rather than Assimp's, because reading it is checking it: every index,
// offset and count is compared with what is there before it is used, and complaints name the place. It also keeps what
// Assimp 5.2 drops: cubic splines, instances, refraction indices, emissive strength, both texture coordinate sets.
#include <algorithm>
#include <array>
#include <string_view>

#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

// Extensions a file may require.
constexpr std::array<std::string_view, 17> kUnderstood{
    "KHR_texture_transform",      "KHR_materials_unlit",      "KHR_materials_ior",
    "KHR_materials_transmission", "KHR_materials_volume",     "KHR_materials_specular",
    "KHR_lights_punctual",        "KHR_mesh_quantization",    "EXT_mesh_gpu_instancing",
    "KHR_materials_clearcoat",    "KHR_materials_sheen",      "KHR_materials_iridescence",
    "KHR_materials_anisotropy",   "KHR_materials_dispersion", "KHR_materials_emissive_strength",
    "KHR_materials_variants",     "KHR_xmp_json_ld",
};

void checkAsset(const Document &document) {
  const Value version = document.root().at("asset").at("version");
  if (!version.text().starts_with("2.")) version.complain("is \"{}\", only 2.0 is read", version.text());
  const Value required = document["extensionsRequired"];
  for (size_t i = 0; i < required.size(); ++i) {
    const std::string name = required[i].text();
    const bool known = std::find(kUnderstood.begin(), kUnderstood.end(), name) != kUnderstood.end();
    if (!known) required[i].complain("the file cannot be drawn without {}, which is not understood", name);
  }
}

}  // namespace

Scene readGltf(std::string_view bytes, const std::string &folder) {
  Document document(bytes, folder);
  checkAsset(document);
  readTextures(document);
  readMaterials(document);
  readMeshes(document);
  readCameras(document);
  readLights(document);
  readNodes(document);
  readSkins(document);
  readAnimations(document);
  return std::move(document.scene);
}

}  // namespace rc::tool::gltf
