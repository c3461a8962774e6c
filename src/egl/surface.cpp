// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/surface.h"

namespace rc::egl {
namespace {

constexpr uint32_t kBlack = 0xff000000u;

// What is left of a colour in a buffer of 5, 6 and 5 bits; the upper bits are repeated, so that full stays full.
uint32_t roundTo565(uint32_t rgba) {
  const auto keep = [&](int shift, int bits) {
    const uint32_t top = (rgba >> shift & 255) >> (8 - bits) << (8 - bits);
    return (top | top >> bits) << shift;
  };
  return keep(0, 5) | keep(8, 6) | keep(16, 5) | (rgba & kBlack);
}

}  // namespace

Surface::Surface(const Config &config, EGLint kind, const SurfaceAttributes &initial, Size size,
                 std::unique_ptr<NativeDrawable> drawable, EGLNativeWindowType native)
    : attributes(initial), mConfig(config), mKind(kind), mNative(native), mDrawable(std::move(drawable)), mSize(size) {}

bool Surface::checkNative() {
  nextSize();
  return !mGone;
}

Size Surface::nextSize() {
  if (!mDrawable || mGone) return size();
  const std::optional<Size> now = mDrawable->size();
  if (!now) mGone = true;
  return now.value_or(size());
}

void Surface::followNative() {
  const Size now = nextSize();
  if (now == size()) return;
  mPixels.clear();
  mSwapped = false;
  mSize = now;
}

hal::Target Surface::backBuffer() {
  followNative();
  return picture();
}

hal::Target Surface::picture() {
  const Size size = mSize;
  if (mPixels.empty()) mPixels.assign(size_t(size.width) * size_t(size.height), kBlack);
  return {mPixels.data(), size.width, size.height};
}

void Surface::asked() {
  if (fences) fences->ask();
}

void Surface::traced() {
  if (mConfig.red == 5) {
    for (uint32_t &pixel : mPixels) pixel = roundTo565(pixel);
  }
  if (showsAtOnce()) {
    mSwapped = true;
    present();
  }
  if (fences) fences->pass();
}

// Nobody waits for a picture that will not be.
void Surface::failed() {
  if (fences) fences->passAll();
}

bool Surface::present() {
  if (!mDrawable) return true;
  if (!mGone && mDrawable->present(picture())) return true;
  mGone = true;
  return false;
}

}  // namespace rc::egl
