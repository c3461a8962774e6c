// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/texture_binding.h"

#include "egl/surface.h"

namespace rc::egl {
namespace {

// Textures begin with the bottom row, surfaces with the top one. Texels without alpha get what rcTexImage2D gives them.
std::vector<uint32_t> texelsOf(const hal::Target &picture, bool withAlpha, uint32_t alpha) {
  std::vector<uint32_t> texels;
  texels.reserve(size_t(picture.width) * size_t(picture.height));
  for (int y = picture.height - 1; y >= 0; --y) {
    const uint32_t *row = picture.pixels + size_t(y) * size_t(picture.width);
    for (int x = 0; x < picture.width; ++x) {
      texels.push_back(withAlpha ? row[x] : (row[x] & 0x00ffffffu) | alpha << 24);
    }
  }
  return texels;
}

}  // namespace

void TextureBinding::bind(api::Context &context, Surface &surface) {
  const std::lock_guard lock(context.objects().mutex);
  const hal::Target picture = surface.picture();
  const bool withAlpha = surface.attributes.textureFormat == EGL_TEXTURE_RGBA;
  const std::shared_ptr<ddk::Texture> &texture = context.state.texture.bound[ddk::kColourMap].texture;
  // A pbuffer may be 0 pixels high: the texture then has no image.
  const bool empty = picture.width <= 0 || picture.height <= 0;
  texture->image = empty ? ddk::Image{}
                         : ddk::makeImage(texelsOf(picture, withAlpha, context.state.texture.alpha), picture.width,
                                          picture.height, surface.attributes.mipmapTexture != EGL_FALSE);
  texture->format = withAlpha ? RC_RGBA : RC_RGB;
  mTexture = texture;
  mObjects = context.shared();
  mTexels = empty ? nullptr : texture->image.levels[0].data();
  context.touch();
}

bool TextureBinding::bound() const {
  const auto texture = mTexture.lock();
  return texture && !texture->image.levels.empty() && texture->image.levels[0].data() == mTexels;
}

void TextureBinding::release() {
  const auto objects = mObjects.lock();
  if (!objects) return;
  const std::lock_guard lock(objects->mutex);
  if (!bound()) return;
  mTexture.lock()->image = {};
  mTexture.reset();
  ++objects->changes;
}

}  // namespace rc::egl
