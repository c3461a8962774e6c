// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/texture_binding.h"

#include "egl/surface.h"

namespace rc::egl {
namespace {

// Textures begin with the bottom row, surfaces with the top one. Texels without alpha get what rcTexImage2D gives them.
ddk::Texels texelsOf(const hal::Target &picture, bool withAlpha, uint32_t alpha) {
  ddk::Texels texels;
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

std::shared_ptr<const TextureBinding::Loan> TextureBinding::loan() const {
  const std::lock_guard lock(mMutex);
  return mLoan.lock();
}

bool TextureBinding::bind(api::Context &context, Surface &surface) {
  const std::lock_guard lock(context.objects().mutex);
  const std::shared_ptr<ddk::Texture> &texture = context.state.texture.bound[ddk::kColourMap].texture;
  const bool withAlpha = surface.attributes.textureFormat == EGL_TEXTURE_RGBA;
  const hal::Target picture = surface.picture();
  // A pbuffer may be 0 pixels high: the texture then has no image.
  std::shared_ptr<ddk::Image> image;
  if (picture.width > 0 && picture.height > 0) {
    image = ddk::makeImage(texelsOf(picture, withAlpha, context.state.texture.alpha), picture.width, picture.height,
                           surface.attributes.mipmapTexture != EGL_FALSE);
  }
  const auto lent = std::make_shared<const Loan>(Loan{texture, context.shared()});

  const std::lock_guard own(mMutex);
  if (!mLoan.expired()) return false;
  mLoan = lent;
  texture->load(std::move(image), withAlpha ? RC_RGBA : RC_RGB);
  texture->loan = lent;
  context.touch();
  return true;
}

bool TextureBinding::boundTo(const ddk::Texture &texture) const {
  const auto lent = loan();
  return lent && lent->texture.lock().get() == &texture;
}

void TextureBinding::release() {
  const auto lent = loan();
  const auto objects = lent ? lent->objects.lock() : nullptr;
  const auto texture = lent ? lent->texture.lock() : nullptr;
  if (!objects || !texture) return;
  const std::lock_guard lock(objects->mutex);
  if (texture->loan != lent) return;
  texture->load(nullptr, texture->format);
  ++objects->changes;
}

}  // namespace rc::egl
