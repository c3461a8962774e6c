// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/material.h"

namespace rc::ddk {
namespace {

// What of a light a transmitting surface lets through. [reference 4.2]
// Grey surfaces pass t; coloured ones t^(5 - 4 diffuse) per channel, so that their own colour passes best.
Rgb shadowTint(const Rgb &transmittance, const Rgb &diffuse, bool colourShadow) {
  if (!colourShadow) return Rgb((transmittance.x + transmittance.y + transmittance.z) / 3);
  if (diffuse.x == diffuse.y && diffuse.y == diffuse.z) return transmittance;
  Rgb tint;
  for (int i = 0; i < 3; ++i) tint[i] = std::pow(transmittance[i], 5 - 4 * diffuse[i]);
  return tint;
}

// The material's wrap modes if it has them, else the texture's.
hal::Wraps wrapsOf(const TextureUse &use) {
  if (!use.texture) return {};
  return {wrapOf(use.wrapS.value_or(use.texture->wrapS)), wrapOf(use.wrapT.value_or(use.texture->wrapT))};
}

// A combiner is shaded as its initial state, which modulates.
hal::TextureEnv environmentOf(RCenum mode) {
  switch (mode) {
    case RC_REPLACE:
      return hal::TextureEnv::Replace;
    case RC_DECAL:
      return hal::TextureEnv::Decal;
    case RC_BLEND:
      return hal::TextureEnv::Blend;
    case RC_ADD:
      return hal::TextureEnv::Add;
    default:
      return hal::TextureEnv::Modulate;
  }
}

}  // namespace

hal::MaterialRow materialRow(const Material &material, bool colourShadow) {
  hal::MaterialRow row;
  row.ambient = material.ambient;
  row.diffuse = material.diffuse;
  row.specular = material.specular * material.specularLevel;
  row.emission = material.emission;
  row.reflection = material.reflection;
  row.transmittance = material.transmittance;
  for (int i = 0; i < 3; ++i) {
    const float sum = row.reflection[i] + row.transmittance[i];
    if (sum <= 1) continue;
    row.reflection[i] /= sum;
    row.transmittance[i] /= sum;
  }
  row.shadowTint = shadowTint(row.transmittance, material.diffuse, colourShadow);
  row.shininess = material.shininess;
  row.leastShine = hal::leastShineOf(row.shininess);
  row.refractionIndex = material.refractionIndex > 0 ? material.refractionIndex : 1;  // 0 bends nothing
  row.textureWrap = wrapsOf(material.textures[kColourMap]);
  row.normalWrap = wrapsOf(material.textures[kNormalMap]);
  row.textureEnv = environmentOf(material.textureEnvMode);
  row.textureEnvColor = Rgb(material.textureEnvColor);
  return row;
}

}  // namespace rc::ddk
