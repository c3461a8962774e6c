// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/surface.h"

#include <cmath>

namespace rc::tool {
namespace {

// Mean of the texture's channels, 0 ... 1.
Vec4 average(const Scene &scene, const TextureUse &use) {
  if (!use.used()) return Vec4(1);
  const std::vector<uint8_t> &rgba = scene.images[size_t(scene.textures[size_t(use.texture)].image)].rgba;
  double sums[4] = {};
  for (size_t i = 0; i < rgba.size(); ++i) sums[i % 4] += rgba[i];
  const double scale = 4.0 / (255.0 * double(rgba.size()));
  return Vec4(sums[0] * scale, sums[1] * scale, sums[2] * scale, sums[3] * scale);
}

Vec3 divided(const Vec3 &colour, const Vec3 &share) {
  return glm::clamp(colour / glm::max(share, Vec3(1e-3f)), Vec3(0), Vec3(1));
}

// Share of light an interface mirrors at right angles. [Schlick 1994]
float reflectanceOf(float ior) {
  const float root = (ior - 1) / (ior + 1);
  return root * root;
}

// Light is lost along the way through the volume; a ray meets two surfaces on it, and each takes half. [Beer-Lambert]
Vec3 tintOf(const Material &material, const Vec3 &base) {
  if (material.thickness <= 0) return base;
  const float way = material.thickness / material.attenuationDistance;
  const Vec3 through = glm::pow(glm::max(material.attenuationColor, Vec3(1e-4f)), Vec3(way));
  return glm::sqrt(base * encoded(through));
}

// Exponent of Phong's highlight that is as wide as that of the microfacets. [Walter et al. 2007; the half vector's
// exponent is four times the mirror vector's]
float exponentOf(float roughness) {
  const float alpha = std::max(roughness * roughness, 0.02f);
  return std::max((2 / (alpha * alpha) - 2) / 4, 1.0f);
}

Surface fromClassic(const Material &material) {
  const Classic &phong = material.phong;
  Surface surface;
  surface.ambient = surface.diffuse = phong.diffuse;
  surface.specular = phong.shininess > 0 ? phong.specular : Vec3(0);
  surface.emission = glm::min(phong.emission, Vec3(1));
  surface.reflection = phong.reflection;
  surface.transmittance = phong.transmittance;
  surface.shininess = phong.shininess;
  surface.refractionIndex = material.ior;
  return surface;
}

Surface fromUnlit(const Material &material) {
  Surface surface;
  surface.ambient = surface.diffuse = Vec3(0);
  surface.emission = encoded(Vec3(material.baseColor));
  return surface;
}

}  // namespace

Material asDrawn(Material material) {
  const bool black = maxOf(Vec3(material.baseColor)) <= 0;
  if (material.classic || material.unlit || !black || !material.emissiveTexture.used()) return material;
  material.unlit = true;
  material.baseTexture = material.emissiveTexture;
  material.baseColor = Vec4(material.emissive, material.baseColor.w);
  material.emissiveTexture = material.normalTexture = {};
  return material;
}

Averages averagesOf(const Scene &scene, const Material &material) {
  Averages averages;
  averages.base = Vec3(average(scene, material.baseTexture));
  const Vec4 metallicRoughness = average(scene, material.metallicRoughnessTexture);
  averages.roughness = metallicRoughness.y;
  averages.metallic = metallicRoughness.z;
  averages.transmission = average(scene, material.transmissionTexture).x;
  return averages;
}

Surface surfaceOf(const Material &material, const Averages &averages) {
  if (material.classic) return fromClassic(material);
  if (material.unlit) return fromUnlit(material);
  const float metallic = material.metallic * averages.metallic, roughness = material.roughness * averages.roughness;
  const float smooth = (1 - roughness) * (1 - roughness);
  const float through = material.transmission * averages.transmission * (1 - metallic);
  const Vec3 factor = encoded(Vec3(material.baseColor)), base = factor * averages.base;
  const Vec3 coat = reflectanceOf(material.ior) * material.specular * material.specularColor;

  Surface surface;
  // An insulator mirrors twice what it does at right angles, for the grazing rays that RayCore has no Fresnel term for.
  const Vec3 mirrored = glm::mix(2.0f * coat, base, metallic) * smooth;
  surface.reflection = glm::min(mirrored, Vec3(1));
  surface.transmittance = through * (1.0f - mirrored) * tintOf(material, base);
  surface.refractionIndex = material.thickness > 0 && through > 0 ? std::max(material.ior, 1.0f) : 1;

  // RayCore takes reflection and transmittance off the local colour; what rough metal scatters stays with it.
  const Vec3 left = 1.0f - surface.reflection - surface.transmittance;
  const float local = (1 - metallic) * (1 - through) + metallic * (1 - smooth);
  surface.diffuse = surface.ambient = divided(factor * local, left);
  surface.specular = divided(encoded(glm::mix(coat, Vec3(material.baseColor), metallic)) * (1 - roughness), left);
  surface.shininess = exponentOf(roughness);
  if (!material.emissiveTexture.used()) surface.emission = encoded(material.emissive);
  return surface;
}

void noteApproximations(const Material &material, Scene &scene) {
  if (material.classic) return;
  if (material.metallicRoughnessTexture.used()) {
    scene.note("metallic-roughness textures: a material has one roughness; their mean is used");
  }
  if (material.emissiveTexture.used()) {
    scene.note("emissive textures: added to the colour texture; they do not glow in the dark");
  }
  if (maxOf(material.emissive) > 1) scene.note("emission above 1: cut to 1; it lights nothing else");
  if (material.transmission > 0 && material.roughness > 0.1f) {
    scene.note("rough transmission: RayCore's refracted rays are sharp");
  }
  if (material.transmissionTexture.used()) scene.note("transmission textures: their mean is used");
  if (material.thickness > 0) scene.note("volumes: absorption by their thickness, half at each surface");
  const TextureUse &normal = material.normalTexture;
  if (normal.used() && material.baseTexture.used() && !normal.samePlace(material.baseTexture)) {
    scene.note("normal maps with other texture coordinates than the colour: not used");
  }
}

}  // namespace rc::tool
