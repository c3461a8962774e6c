// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// surface.h: a window, a pixmap or an off-screen picture that a context traces into. [spec 5; EGL 1.5, 3.5]
#pragma once

#include <atomic>
#include <memory>

#include "api/context.h"
#include "base/memory.h"
#include "egl/handle_table.h"
#include "egl/platform.h"
#include "egl/surface_attributes.h"
#include "egl/sync.h"
#include "egl/texture_binding.h"

namespace rc::egl {

class Surface final : public api::DrawSurface, public Handled {
 public:
  // kind: EGL_WINDOW_BIT, EGL_PBUFFER_BIT, EGL_PIXMAP_BIT. drawable: null for off-screen surfaces.
  Surface(const Config &config, EGLint kind, const SurfaceAttributes &initial, Size size,
          std::unique_ptr<NativeDrawable> drawable, EGLNativeWindowType native);

  const Config &config() const { return mConfig; }
  EGLint kind() const { return mKind; }
  EGLNativeWindowType native() const { return mNative; }
  Size size() const { return mSize; }
  // Its window or pixmap no longer exists.
  bool gone() const { return mGone; }
  // Looks whether it still exists.
  bool checkNative();
  // The size that its window has now, and the next picture will have.
  Size nextSize();
  // What a context draws is seen when it is traced, not at a swap.
  bool showsAtOnce() const { return attributes.renderBuffer == EGL_SINGLE_BUFFER; }
  // Swaps since the back buffer had the contents it has now; 0 if they are not defined. [EGL_EXT_buffer_age]
  EGLint age() const { return mSwapped ? 1 : 0; }

  SurfaceAttributes attributes;
  TextureBinding texture;    // by eglBindTexImage
  Fences *fences = nullptr;  // of the context that draws to it

  hal::Target backBuffer() override;
  int samples() const override { return std::max(mConfig.samples, 1); }
  void asked() override;
  void traced() override;
  void failed() override;

  // What was traced last, at the size it was traced for.
  hal::Target picture();
  // It is about to be shown.
  void noteSwapped() { mSwapped = true; }
  // Shows it, on any thread; false if the window is gone.
  bool present();
  bool closeRequested() { return mDrawable && !mGone && mDrawable->closeRequested(); }

 private:
  // Takes the size that its window has now: pixels of another size are lost.
  void followNative();

  const Config &mConfig;
  EGLint mKind;
  EGLNativeWindowType mNative;
  std::unique_ptr<NativeDrawable> mDrawable;
  std::atomic<Size> mSize;  // read by any thread
  Array<uint32_t> mPixels;  // RGBA8, the top row first; empty until they are needed
  std::atomic<bool> mGone = false;
  std::atomic<bool> mSwapped = false;
};

}  // namespace rc::egl
