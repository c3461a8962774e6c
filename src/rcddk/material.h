// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material.h: material objects, global and by reference: a primitive remembers the name, and what the
// material holds when the frame is traced is what is seen. [spec 3.5; G 6]
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "rcddk/texture.h"

namespace rc::ddk {

// The two places a material has for a texture.
enum TextureSlot : size_t { kColourMap = 0, kNormalMap = 1, kTextureSlots = 2 };

struct TextureUse {
  bool enabled = false;
  RCuint name = 0;                     // for the gets
  std::shared_ptr<Texture> texture;    // kept alive after its name is deleted
  std::optional<RCenum> wrapS, wrapT;  // set while the material was bound; else the texture's

  bool operator==(const TextureUse &) const = default;
};

struct Material {
  Rgb ambient{0.2f}, diffuse{0.8f}, specular{0}, emission{0};
  Rgb reflection{0}, transmittance{0};
  float refractionIndex = 1;
  float shininess = 0;
  float specularLevel = 1;  // the profile may say 0
  float roughness = 0;      // second generation; stored
  std::array<TextureUse, kTextureSlots> textures;
  RCenum textureEnvMode = RC_REPLACE;  // how the texel and the colours meet [spec 3.4]
  Vec4 textureEnvColor{0};

  bool operator==(const Material &) const = default;

  // The texture that shading reads in a place, or null.
  const Texture *visibleTexture(TextureSlot slot) const {
    const TextureUse &use = textures[slot];
    return use.enabled && use.texture && use.texture->loaded() ? use.texture.get() : nullptr;
  }
};

// The material as the device sees it, but for the indices of its textures.
hal::MaterialRow materialRow(const Material &material, bool colourShadow);

}  // namespace rc::ddk
