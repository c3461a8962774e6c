// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture_binding.h: a pbuffer's picture in a texture, from eglBindTexImage to eglReleaseTexImage. [EGL 1.5, 3.6]
#pragma once

#include <memory>

#include "api/context.h"

namespace rc::egl {

class Surface;

class TextureBinding {
 public:
  // The picture becomes the image of the context's current RC_TEXTURE_2D.
  void bind(api::Context &context, Surface &surface);
  // False once the texture was loaded anew or no longer exists.
  bool bound() const;
  bool boundTo(const ddk::Texture &texture) const { return bound() && mTexture.lock().get() == &texture; }
  // The texture is empty again.
  void release();

 private:
  std::weak_ptr<ddk::Texture> mTexture;
  std::weak_ptr<api::SharedObjects> mObjects;  // where it lives
  const uint32_t *mTexels = nullptr;           // of its image, which tell that it is ours
};

}  // namespace rc::egl
