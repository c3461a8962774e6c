// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/thread.h"

#include <cstddef>
#include <new>
#include <utility>

namespace rc::egl {
namespace {

// next: what takes its place.
void leave(const Current &old, const Current &next) {
  if (!old.context) return;
  if (old.context != next.context) old.context->api.attach(nullptr);
  old.context->fences.passAll();  // nobody waits for a picture that is not asked for any more
  old.context->current = false;
  if (!old.draw) return;
  old.draw->fences = nullptr;
  old.draw->current = old.read->current = false;
}

void enterInto(const Current &now) {
  if (!now.context) return;
  now.context->current = true;
  if (!now.draw) return;
  now.draw->current = now.read->current = true;
  now.draw->fences = &now.context->fences;
}

// Handles that were destroyed while they were current end now.
void release(const Current &old) {
  if (!old.context) return;
  old.display->contexts.release(*old.context);
  if (!old.draw) return;
  old.display->surfaces.release(*old.draw);
  old.display->surfaces.release(*old.read);
}

}  // namespace

ThreadState::~ThreadState() {
  awaitPicture();
  const std::lock_guard lock(displayMutex());
  makeCurrent({});
}

void ThreadState::awaitPicture() const {
  if (current.context) current.context->api.awaitPicture();
}

void ThreadState::makeCurrent(Current next) {
  if (next == current) return;
  // First, since a surface may need more memory than there is: then nothing has changed.
  if (next.context) next.context->api.attach(next.draw.get());
  const Current old = std::exchange(current, std::move(next));
  leave(old, current);
  enterInto(current);
  release(old);
  api::setCurrentContext(current.context ? &current.context->api : nullptr);
}

// The destructor of a global may come after the end of the main thread's own state: it gets a new one, which stays.
ThreadState &threadState() {
  struct Place {
    alignas(ThreadState) std::byte bytes[sizeof(ThreadState)];
    ThreadState *state;
  };
  struct End {
    Place &place;
    ~End() {
      place.state->~ThreadState();
      place.state = nullptr;
    }
  };
  static constinit thread_local Place place{};
  if (!place.state) {
    place.state = new (place.bytes) ThreadState;
    static const thread_local End end{place};
    static_cast<void>(end);
  }
  return *place.state;
}

}  // namespace rc::egl
