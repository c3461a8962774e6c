// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/textures.h"

#include <algorithm>
#include <cmath>

#include "draw/resample.h"

namespace rc::tool {
namespace {

RCint wrapToken(Wrap wrap) {
  constexpr RCint kTokens[] = {RC_REPEAT, RC_CLAMP_TO_EDGE, RC_MIRRORED_REPEAT};
  return kTokens[int(wrap)];
}

// Of the texture that is bound.
void setParameters(RCenum target, const TextureFilter &filter) {
  rcTexParameteri(target, RC_TEXTURE_MIN_FILTER, filter.minFilter);
  rcTexParameteri(target, RC_TEXTURE_MAX_ANISOTROPY_EXT, filter.anisotropy);
}

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

float linearOf(uint8_t byte) {
  const float c = float(byte) / 255;
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

// A factor of the file goes into the texels only where RayCore's material has no place for it.
void multiply(Image &image, const Vec4 &factor) {
  if (factor == Vec4(1)) return;
  for (size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = byteOf(float(image.rgba[i]) / 255 * factor[int(i % 4)]);
}

void addLight(Image &image, const Image &light, const Vec3 &strength) {
  for (size_t y = 0; y < size_t(image.height); ++y) {
    for (size_t x = 0; x < size_t(image.width); ++x) {
      const size_t lx = x * size_t(light.width) / size_t(image.width),
                   ly = y * size_t(light.height) / size_t(image.height);
      const uint8_t *from = &light.rgba[(ly * size_t(light.width) + lx) * 4];
      uint8_t *to = &image.rgba[(y * size_t(image.width) + x) * 4];
      for (size_t c = 0; c < 3; ++c) {
        to[c] = std::max(to[c], byteOf(encoded(linearOf(from[c]) * strength[int(c)])));
      }
    }
  }
}

void makeOpaque(Image &image) {
  for (size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
}

Image plain(int width, int height) {
  return {"", width, height, std::vector<uint8_t>(size_t(width) * size_t(height) * 4, 255)};
}

// glTF's green points up the picture, RayCore's along v, down the picture.
Image normalsFor(const Image &from, float scale) {
  Image image = from;
  const auto scaled = [&](uint8_t byte, float by) { return byteOf(0.5f + by * (float(byte) / 255 - 0.5f)); };
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = scaled(image.rgba[i], scale);
    image.rgba[i + 1] = scaled(image.rgba[i + 1], -scale);
  }
  return image;
}

}  // namespace

const Image &Textures::imageOf(const TextureUse &use) const {
  return mScene.images[size_t(mScene.textures[size_t(use.texture)].image)];
}

const TextureUse &Textures::placeOf(const Material &material) {
  if (material.baseTexture.used()) return material.baseTexture;
  return material.emissiveTexture.used() ? material.emissiveTexture : material.normalTexture;
}

Image Textures::colourOf(const Material &material) const {
  const TextureUse &base = material.baseTexture, &glow = material.emissiveTexture;
  const bool glows = glow.used() && (!base.used() || glow.samePlace(base));
  Image image = base.used() ? imageOf(base) : glows ? plain(imageOf(glow).width, imageOf(glow).height) : plain(16, 16);
  Vec4 factor(1, 1, 1, material.classic ? 1 : material.baseColor.w);
  if (material.unlit) factor = Vec4(encoded(Vec3(material.baseColor)), factor.w);
  multiply(image, factor);
  if (glows) addLight(image, imageOf(glow), material.emissive);
  if (material.alphaMode == AlphaMode::Opaque && !material.classic) makeOpaque(image);
  return image;
}

bool Textures::bindColour(const Material &material) {
  const bool sheer = material.alphaMode == AlphaMode::Blend && material.baseColor.w < 1;
  if (!material.baseTexture.used() && !material.emissiveTexture.used() && !sheer) return false;
  // A mask: the alpha that just passes is opaque, and the alpha test of the draw lets only opaque points stand.
  const bool mask = material.alphaMode == AlphaMode::Mask;
  const RCint opaque = mask ? int(std::ceil(std::clamp(material.alphaCutoff * 255, 1.0f, 255.0f))) : 255;
  const TextureUse &place = placeOf(material);
  const Texture texture = place.used() ? mScene.textures[size_t(place.texture)] : Texture{};
  upload(RC_TEXTURE_2D, colourOf(material), texture, opaque);
  rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, RC_MODULATE);
  rcEnable(RC_TEXTURE_2D);
  return true;
}

bool Textures::bindNormals(const Material &material) {
  const TextureUse &use = material.normalTexture;
  if (!use.used() || !use.samePlace(placeOf(material))) return false;
  upload(RC_TEXTURE_2D_NORMAL, normalsFor(imageOf(use), material.normalScale), mScene.textures[size_t(use.texture)],
         255);
  rcEnable(RC_TEXTURE_2D_NORMAL);
  return true;
}

void Textures::setFilter(const TextureFilter &filter) const {
  rcBindMaterial(0);  // whose texture is nobody's
  for (const Uploaded &texture : mUploaded) {
    rcBindTexture(texture.target, texture.name);
    setParameters(texture.target, filter);
  }
}

void Textures::upload(RCenum target, const Image &image, const Texture &texture, RCint opaqueAlpha) {
  const Image fitting = forDevice(image);
  RCuint name = 0;
  rcGenTextures(1, &name);
  rcBindTexture(target, name);
  mUploaded.push_back({target, name});
  if (std::max(fitting.width, fitting.height) > 1024) rcEnable(RC_LARGE_TEXTURES);
  rcTexParameteri(target, RC_TEXTURE_WRAP_S, wrapToken(texture.wrapS));
  rcTexParameteri(target, RC_TEXTURE_WRAP_T, wrapToken(texture.wrapT));
  setParameters(target, {});
  rcTexParameteri(target, RC_TEXTURE_OPAQUE_ALPHA, opaqueAlpha);
  rcTexImage2D(target, 0, RC_RGBA, fitting.width, fitting.height, 0, RC_RGBA, RC_UNSIGNED_BYTE, fitting.rgba.data());
}

}  // namespace rc::tool
