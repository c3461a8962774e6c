// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// sync.h: fences. One is passed when the picture that its context was asked for is traced. [EGL 1.5, 3.8]
#pragma once

#include <EGL/egl.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "egl/handle_table.h"

namespace rc::egl {

struct RenderContext;

class Sync : public Handled {
 public:
  explicit Sync(std::weak_ptr<RenderContext> context) : mContext(std::move(context)) {}

  std::shared_ptr<RenderContext> context() const { return mContext.lock(); }
  bool signaled() const;
  void signal();
  // Nanoseconds, or EGL_FOREVER. False if they are over.
  bool wait(EGLTime timeout) const;

 private:
  std::weak_ptr<RenderContext> mContext;
  mutable std::mutex mMutex;
  mutable std::condition_variable mChanged;
  bool mSignaled = false;
};

// The fences in a context's stream of commands that are not passed yet. Pictures are made on any thread.
class Fences {
 public:
  // A fence behind all that was drawn so far; asks: that is not traced yet, nor about to be.
  void add(const std::shared_ptr<Sync> &sync, bool asks);
  // A picture of all that was asked for so far is about to be traced; it is done.
  void ask();
  void pass();
  // All that was asked for is done, or nobody waits for it.
  void passAll();

 private:
  std::mutex mMutex;
  std::vector<std::shared_ptr<Sync>> mWaiting, mAsked;
  bool mTracing = false;  // from ask() to pass()
};

}  // namespace rc::egl
