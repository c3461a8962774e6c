// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// display.h: an EGL display, which owns surfaces and contexts. Handles are pointers that are looked up before
// they are used: a handle that is none is an error, never a crash. [spec 5; EGL 1.4, 2.1, 3.2]
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "egl/surface.h"

namespace rc::egl {

// What an EGLContext stands for.
struct RenderContext {
  RenderContext(const Config &chosen, const Settings &settings, std::shared_ptr<api::SharedObjects> shared)
      : config(chosen), api(settings, std::move(shared)) {}

  const Config &config;
  api::Context api;
  bool current = false;  // on some thread
};

// Objects by handle. Those in use outlive their removal: whoever uses one shares it.
template <class Object>
class HandleTable {
 public:
  void *add(std::shared_ptr<Object> object) {
    void *handle = object.get();
    mObjects.emplace(handle, std::move(object));
    return handle;
  }
  std::shared_ptr<Object> find(void *handle) const {
    const auto found = mObjects.find(handle);
    return found == mObjects.end() ? nullptr : found->second;
  }
  void remove(void *handle) { mObjects.erase(handle); }
  void clear() { mObjects.clear(); }

 private:
  std::map<void *, std::shared_ptr<Object>> mObjects;
};

struct Display {
  EGLNativeDisplayType native;
  bool initialized = false;
  std::unique_ptr<Platform> platform;  // null until a window is asked for, or without a window system
  HandleTable<Surface> surfaces;
  HandleTable<RenderContext> contexts;

  // Connects on first use.
  Platform *connect();
};

// The same display for the same native one; never removed.
Display *displayFor(EGLNativeDisplayType native);
// Null for handles that are no display.
Display *findDisplay(EGLDisplay handle);

// EGL calls of all threads change displays one after the other; tracing is not under this lock.
std::recursive_mutex &displayMutex();

}  // namespace rc::egl
