// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/texture_binding.h"

#include "egl/surface.h"

namespace rc::egl {
namespace {

bool hasAlpha(const Surface &surface) { return surface.attributes.textureFormat == EGL_TEXTURE_RGBA; }

}  // namespace

// Textures begin with the bottom row, surfaces with the top one.
TextureBinding::Copy TextureBinding::copyOf(Surface &surface, uint32_t alpha) {
  const hal::Target picture = surface.picture();
  Copy copy{{}, picture.width, picture.height};
  copy.texels.reserve(size_t(picture.width) * size_t(picture.height));
  for (int y = picture.height - 1; y >= 0; --y) {
    const uint32_t *row = picture.pixels + size_t(y) * size_t(picture.width);
    for (int x = 0; x < picture.width; ++x) {
      copy.texels.push_back(hasAlpha(surface) ? row[x] : (row[x] & 0x00ffffffu) | alpha << 24);
    }
  }
  return copy;
}

std::shared_ptr<const TextureBinding::Loan> TextureBinding::loan() const {
  const std::lock_guard lock(mMutex);
  return mLoan.lock();
}

bool TextureBinding::bind(api::Context &context, const Surface &surface, Copy copy) {
  const std::lock_guard lock(context.objects().mutex);
  const std::shared_ptr<ddk::Texture> &texture = context.state.texture.bound[ddk::kColourMap].texture;
  // A pbuffer may be 0 pixels high: the texture then has no image.
  std::shared_ptr<ddk::Image> image;
  if (copy.width > 0 && copy.height > 0) {
    image =
        ddk::makeImage(std::move(copy.texels), copy.width, copy.height, surface.attributes.mipmapTexture != EGL_FALSE);
  }
  const auto lent = std::make_shared<const Loan>(Loan{texture, context.shared()});

  const std::lock_guard own(mMutex);
  if (!mLoan.expired()) return false;
  mLoan = lent;
  texture->load(std::move(image), hasAlpha(surface) ? RC_RGBA : RC_RGB);
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
