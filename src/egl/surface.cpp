// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/surface.h"

namespace rc::egl {

hal::Target Surface::backBuffer() {
  if (mWindow && !mGone) {
    if (const std::optional<Size> now = mWindow->size()) {
      if (*now != mSize) resize(*now);
    } else {
      mGone = true;
    }
  }
  return picture();
}

bool Surface::present() {
  if (!mWindow) return true;
  if (!mGone && mWindow->present(picture())) return true;
  mGone = true;
  return false;
}

void Surface::resize(Size size) {
  mPixels.assign(size_t(size.width) * size_t(size.height), 0xff000000u);
  mSize = size;
}

}  // namespace rc::egl
