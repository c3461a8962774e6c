// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture_binding.h: a pbuffer's picture in a texture, from eglBindTexImage to eglReleaseTexImage. [EGL 1.5, 3.6]
#pragma once

#include <memory>
#include <mutex>

#include "api/context.h"

namespace rc::egl {

class Surface;

// Of any thread. What touches the texture waits for a trace that reads it, so none of it is done under the display lock
// but boundTo, which asks the loan alone.
class TextureBinding {
 public:
  // What the surface shows. Nobody may draw to it meanwhile. alpha: of texels where the surface has none.
  struct Copy {
    ddk::Texels texels;
    int width, height;
  };
  static Copy copyOf(Surface &surface, uint32_t alpha);

  // The copy becomes the image of the context's current RC_TEXTURE_2D. False if one is in a texture already.
  bool bind(api::Context &context, const Surface &surface, Copy copy);
  bool boundTo(const ddk::Texture &texture) const;
  // The texture is empty again, unless it was loaded anew.
  void release();

 private:
  // What the texture holds, and nothing else for long: it ends when the texture is loaded anew or deleted.
  struct Loan {
    std::weak_ptr<ddk::Texture> texture;
    std::weak_ptr<api::SharedObjects> objects;  // where it lives
  };

  std::shared_ptr<const Loan> loan() const;

  mutable std::mutex mMutex;
  std::weak_ptr<const Loan> mLoan;
};

}  // namespace rc::egl
