// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material.h: surfaces as files describe them: glTF's metallic-roughness, or the classic model of MTL and its kin.
// draw/surface.h makes RayCore's Phong of either.
#pragma once

#include <limits>
#include <string>

#include "scene/math.h"

namespace rc::tool {

// A texture, and how its coordinates follow from a set of the mesh.
struct TextureUse {
  int texture = -1;
  int uvSet = 0;
  Vec2 offset{0}, scale{1};
  float rotation = 0;  // radians, as KHR_texture_transform counts

  bool used() const { return texture >= 0; }
  bool samePlace(const TextureUse &other) const {
    return uvSet == other.uvSet && offset == other.offset && scale == other.scale && rotation == other.rotation;
  }
};

enum class AlphaMode : int { Opaque, Mask, Blend };

// MTL, 3DS, Collada: display values.
struct Classic {
  Vec3 ambient{0.2f}, diffuse{0.8f}, specular{0}, emission{0}, reflection{0}, transmittance{0};
  float shininess = 0;
};

struct Material {
  std::string name;
  bool classic = false;  // then classic's values count instead of the factors of glTF
  Classic phong;

  Vec4 baseColor{1};  // linear
  float metallic = 1, roughness = 1;
  Vec3 emissive{0};  // linear, strength included
  float ior = 1.5f;
  float transmission = 0;
  float thickness = 0;       // of KHR_materials_volume; 0: a thin sheet
  Vec3 attenuationColor{1};  // linear
  float attenuationDistance = std::numeric_limits<float>::infinity();
  float specular = 1;
  Vec3 specularColor{1};  // linear

  TextureUse baseTexture, metallicRoughnessTexture, normalTexture, emissiveTexture, transmissionTexture;
  float normalScale = 1;
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool unlit = false;
};

}  // namespace rc::tool
