// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// world.h: what a sequence of calls leaves for the next ones: handles of EGL, memory for vertices that outlives the
// calls that name it, and threads that do one thing after the other.
#pragma once

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <mutex>

#include "RC/rc.h"
#include "RC/rcu.h"
#include "common/worker.h"
#include "input.h"

namespace rc::fuzz {

// A fence may be waited for without end, but not by the thread whose context has to pass it.
struct KnownSync {
  EGLSync sync;
  EGLContext context;
};

class World {
 public:
  static constexpr size_t kDisplays = 2;

  World();
  // Every object of every thread but the calling one is gone; that one lets go first.
  ~World();

  EGLDisplay display(size_t i) const { return mDisplays[i % kDisplays]; }
  EGLConfig config(size_t i) const { return mConfigs[i % mConfigs.size()]; }

  // Any handle that there ever was, of any kind, destroyed ones too.
  void *handle(Input &in);
  void note(void *handle);
  void noteSync(EGLSync sync);
  // Whether eglWaitSync on the calling thread returns.
  bool isOwn(EGLSync sync);

  // Memory of client arrays: filled once, the same for all inputs.
  static const std::byte *vertices(size_t offset);
  // How many vertices a draw call on the calling thread may name.
  static uint64_t drawable();

 private:
  std::mutex mMutex;  // threads share what follows
  EGLDisplay mDisplays[kDisplays];
  std::vector<EGLConfig> mConfigs;
  std::vector<void *> mHandles;
  std::vector<KnownSync> mSyncs;
};

using test::Worker;

}  // namespace rc::fuzz
