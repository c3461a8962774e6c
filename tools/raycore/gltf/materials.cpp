// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <array>

#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

TextureUse textureUse(Document &document, const Value &about) {
  TextureUse use;
  if (!about) return use;
  use.texture = about.at("index").index(document.countOf("textures"));
  size_t set = about["texCoord"].count(0);
  if (const Value transform = about["extensions"]["KHR_texture_transform"]) {
    set = transform["texCoord"].count(set);
    const auto pair = [&](const char *key, const Vec2 &missing) {
      if (!transform[key]) return missing;
      const std::vector<float> v = transform[key].numbers(2);
      return Vec2(v[0], v[1]);
    };
    use.offset = pair("offset", Vec2(0));
    use.scale = pair("scale", Vec2(1));
    use.rotation = transform["rotation"].number(0);
  }
  if (set > 1) document.scene.note("texture coordinate sets above 1: set 0 is used instead");
  use.uvSet = set == 1 ? 1 : 0;
  const int image = document.scene.textures[size_t(use.texture)].image;
  const bool readable = image >= 0 && !document.scene.images[size_t(image)].rgba.empty();
  if (!readable) use.texture = -1;
  return use;
}

void readMetallicRoughness(Document &document, const Value &pbr, Material &material) {
  if (pbr["baseColorFactor"]) {
    const std::vector<float> c = pbr["baseColorFactor"].numbers(4);
    material.baseColor = {c[0], c[1], c[2], c[3]};
  }
  material.metallic = pbr["metallicFactor"].number(1);
  material.roughness = pbr["roughnessFactor"].number(1);
  material.baseTexture = textureUse(document, pbr["baseColorTexture"]);
  material.metallicRoughnessTexture = textureUse(document, pbr["metallicRoughnessTexture"]);
}

void readSurface(Document &document, const Value &about, Material &material) {
  material.name = about["name"].text();
  material.normalTexture = textureUse(document, about["normalTexture"]);
  material.normalScale = about["normalTexture"]["scale"].number(1);
  material.emissiveTexture = textureUse(document, about["emissiveTexture"]);
  material.emissive = about["emissiveFactor"].vec3(Vec3(0));
  material.doubleSided = about["doubleSided"].boolean(false);
  material.alphaCutoff = about["alphaCutoff"].number(0.5f);
  const std::string mode = about["alphaMode"].text("OPAQUE");
  if (mode == "MASK") material.alphaMode = AlphaMode::Mask;
  if (mode == "BLEND") material.alphaMode = AlphaMode::Blend;
  if (about["occlusionTexture"]) document.scene.note("occlusion textures: rays find what is hidden; not used");
}

struct Dropped {
  const char *extension, *why;
};

constexpr std::array kDropped{
    Dropped{"KHR_materials_clearcoat", "clear coats: RayCore's materials have one layer; not drawn"},
    Dropped{"KHR_materials_sheen", "sheen: has no counterpart in Phong's model; not drawn"},
    Dropped{"KHR_materials_iridescence", "iridescence: has no counterpart in Phong's model; not drawn"},
    Dropped{"KHR_materials_anisotropy", "anisotropy: highlights of Phong's model are round; not drawn"},
    Dropped{"KHR_materials_dispersion", "dispersion: one refraction index for all colours"},
};

void readExtensions(Document &document, const Value &extensions, Material &material) {
  material.unlit = extensions["KHR_materials_unlit"].there();
  material.ior = extensions["KHR_materials_ior"]["ior"].number(1.5f);
  material.emissive *= extensions["KHR_materials_emissive_strength"]["emissiveStrength"].number(1);
  const Value transmission = extensions["KHR_materials_transmission"];
  material.transmission = transmission["transmissionFactor"].number(0);
  material.transmissionTexture = textureUse(document, transmission["transmissionTexture"]);
  const Value volume = extensions["KHR_materials_volume"];
  material.thickness = volume["thicknessFactor"].number(0);
  material.attenuationColor = volume["attenuationColor"].vec3(Vec3(1));
  material.attenuationDistance = volume["attenuationDistance"].number(material.attenuationDistance);
  const Value specular = extensions["KHR_materials_specular"];
  material.specular = specular["specularFactor"].number(1);
  material.specularColor = specular["specularColorFactor"].vec3(Vec3(1));
  if (specular["specularTexture"] || specular["specularColorTexture"]) {
    document.scene.note("specular textures: a material has one highlight colour; the factors alone are used");
  }
  for (const Dropped &dropped : kDropped) {
    if (extensions[dropped.extension]) document.scene.note(dropped.why);
  }
}

}  // namespace

void readMaterials(Document &document) {
  const Value materials = document["materials"];
  for (size_t i = 0; i < materials.size(); ++i) {
    Material material;
    readMetallicRoughness(document, materials[i]["pbrMetallicRoughness"], material);
    readSurface(document, materials[i], material);
    readExtensions(document, materials[i]["extensions"], material);
    document.scene.materials.push_back(std::move(material));
  }
}

}  // namespace rc::tool::gltf
