// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: syncs. [EGL 1.5, 3.8.1; EGL_KHR_fence_sync, EGL_KHR_wait_sync]
#include "egl/entry.h"
#include "egl/twins.h"

using namespace rc;
using namespace rc::egl;

namespace {

std::shared_ptr<Sync> syncOf(EGLDisplay dpy, EGLSync handle) {
  return objectOf(initializedDisplay(dpy).syncs, handle, EGL_BAD_PARAMETER);
}

// Looks a sync up under the lock; waiting is done without it.
template <class Check>
std::shared_ptr<Sync> syncToWaitFor(EGLDisplay dpy, EGLSync handle, Check &&check) {
  const std::lock_guard lock(displayMutex());
  auto sync = syncOf(dpy, handle);
  check();
  return sync;
}

}  // namespace

namespace rc::egl {

EGLSync createSync(EGLDisplay dpy, EGLenum type, Attributes list, EGLint error) {
  Display &display = initializedDisplay(dpy);
  require(type == EGL_SYNC_FENCE, error);
  require(!list.more(), EGL_BAD_ATTRIBUTE);
  const Current &current = threadState().current;
  require(current.context && current.display == &display, EGL_BAD_MATCH);
  auto sync = std::make_shared<Sync>(current.context);
  current.context->fences.add(sync, current.context->api.pending());
  return display.syncs.add(std::move(sync));
}

EGLAttrib syncAttribute(EGLDisplay dpy, EGLSync handle, EGLint name) {
  const auto sync = syncOf(dpy, handle);
  switch (name) {
    case EGL_SYNC_TYPE:
      return EGL_SYNC_FENCE;
    case EGL_SYNC_STATUS:
      return sync->signaled() ? EGL_SIGNALED : EGL_UNSIGNALED;
    case EGL_SYNC_CONDITION:
      return EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
    default:
      throw EglError{EGL_BAD_ATTRIBUTE};
  }
}

}  // namespace rc::egl

extern "C" {

EGLSync eglCreateSync(EGLDisplay dpy, EGLenum type, const EGLAttrib *attributes) {
  return enter<EGLSync>(
      EGL_NO_SYNC, [&](ThreadState &) { return createSync(dpy, type, Attributes(attributes), EGL_BAD_PARAMETER); });
}

EGLBoolean eglDestroySync(EGLDisplay dpy, EGLSync sync) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    initializedDisplay(dpy).syncs.destroy(*syncOf(dpy, sync));
    return EGL_TRUE;
  });
}

// Whoever waits for a picture of the thread's own context has it traced, with or without the flag: nobody else can.
EGLint eglClientWaitSync(EGLDisplay dpy, EGLSync handle, EGLint flags, EGLTime timeout) {
  return enterUnlocked<EGLint>(EGL_FALSE, [&](ThreadState &thread) {
    const auto sync =
        syncToWaitFor(dpy, handle, [&] { require(bitsOf<EGL_SYNC_FLUSH_COMMANDS_BIT>(flags), EGL_BAD_PARAMETER); });
    const bool own = thread.current.context && sync->context() == thread.current.context;
    if (own && !sync->signaled() && (flags != 0 || timeout != 0)) {
      thread.current.context->api.complete();
      thread.current.context->fences.passAll();
    }
    return sync->wait(timeout) ? EGL_CONDITION_SATISFIED : EGL_TIMEOUT_EXPIRED;
  });
}

// The commands of one context are done in their order; those after a fence of another wait for it here.
EGLBoolean eglWaitSync(EGLDisplay dpy, EGLSync handle, EGLint flags) {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const auto sync = syncToWaitFor(dpy, handle, [&] {
      require(thread.current.context != nullptr, EGL_BAD_MATCH);
      require(flags == 0, EGL_BAD_PARAMETER);
    });
    if (sync->context() != thread.current.context) sync->wait(EGL_FOREVER);
    return EGL_TRUE;
  });
}

EGLBoolean eglGetSyncAttrib(EGLDisplay dpy, EGLSync sync, EGLint name, EGLAttrib *value) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    const EGLAttrib found = syncAttribute(dpy, sync, name);
    require(value, EGL_BAD_PARAMETER);
    *value = found;
    return EGL_TRUE;
  });
}

}  // extern "C"
