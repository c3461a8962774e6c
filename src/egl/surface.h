// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// surface.h: a window or an off-screen picture that a context traces into. [spec 5; EGL 1.4, 3.5]
#pragma once

#include <memory>
#include <vector>

#include "api/context.h"
#include "egl/config.h"
#include "egl/platform.h"

namespace rc::egl {

class Surface final : public api::DrawSurface {
 public:
  // window: null for off-screen surfaces.
  Surface(const Config &config, Size size, std::unique_ptr<NativeWindow> window)
      : mConfig(config), mWindow(std::move(window)) {
    resize(size);
  }

  const Config &config() const { return mConfig; }
  Size size() const { return mSize; }
  bool isWindow() const { return mWindow != nullptr; }
  bool gone() const { return mGone; }

  bool current = false;  // on some thread

  hal::Target backBuffer() override;
  // What was traced last, at the size it was traced for.
  hal::Target picture() { return {mPixels.data(), mSize.width, mSize.height}; }
  // Shows it; false if the window is gone.
  bool present();
  bool closeRequested() { return mWindow && mWindow->closeRequested(); }

 private:
  void resize(Size size);

  const Config &mConfig;
  std::unique_ptr<NativeWindow> mWindow;
  Size mSize;
  std::vector<uint32_t> mPixels;  // RGBA8, the top row first
  bool mGone = false;
};

}  // namespace rc::egl
