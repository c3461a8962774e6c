// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/surface.h"

namespace rc::egl {
namespace {

constexpr uint32_t kBlack = 0xff000000u;

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
  return {mPixels.data(), size.width, size.height, mConfig.red == 5};
}

void Surface::asked() {
  if (fences) fences->ask();
}

void Surface::traced() {
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
