// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// context_session.h: a context with a small picture in memory, for the life of one input.
#pragma once

#include <vector>

#include "RC/rc.h"
#include "RC/rcu.h"
#include "api/context.h"

namespace rc::fuzz {

class ContextSession : public api::DrawSurface {
 public:
  static constexpr int kWidth = 20, kHeight = 16;

  explicit ContextSession(const Settings &settings) : mContext(settings) {
    mContext.attach(this);
    api::setCurrentContext(&mContext);
  }
  ~ContextSession() override { api::setCurrentContext(nullptr); }
  ContextSession(const ContextSession &) = delete;
  ContextSession &operator=(const ContextSession &) = delete;

  hal::Target backBuffer() override { return {mPixels.data(), kWidth, kHeight}; }
  // What a swap of buffers does.
  void showFrame() {
    mContext.finish();
    mContext.endFrame();
  }

 private:
  std::vector<uint32_t> mPixels = std::vector<uint32_t>(size_t{kWidth} * kHeight);
  api::Context mContext;
};

// Devices and structures that an input may choose; always one thread, so that an input does the same each time.
inline Settings settingsOf(uint8_t choice) {
  Settings settings;
  settings.threads = 1;
  settings.device = choice & 1 ? "ref" : "cpu";
  settings.accel = choice & 2 ? AccelKind::KdTree : AccelKind::Bvh;
  settings.profile = choice & 4 ? "mc" : choice & 8 ? "1000" : "guide";
  return settings;
}

}  // namespace rc::fuzz
