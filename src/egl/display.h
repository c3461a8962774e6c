// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// display.h: an EGL display, which owns surfaces, contexts, syncs and images. Displays are looked up before they are
// used: a handle that is none is an error, never a crash. [spec 5; EGL 1.5, 2.1, 3.2]
#pragma once

#include <memory>
#include <mutex>

#include "egl/handle_table.h"
#include "egl/surface.h"
#include "egl/sync.h"

namespace rc::egl {

// What an EGLContext stands for.
struct RenderContext : Handled {
  RenderContext(const Config &chosen, const Settings &settings, std::shared_ptr<api::SharedObjects> shared)
      : config(chosen), api(settings, std::move(shared)) {}

  const Config &config;
  api::Context api;
  Fences fences;
};

// A picture that other APIs could share; nothing of RayCore makes use of one yet.
struct Image : Handled {
  explicit Image(std::shared_ptr<ddk::Texture> source) : texture(std::move(source)) {}

  std::shared_ptr<ddk::Texture> texture;
};

// What eglGetDisplay and eglGetPlatformDisplay are asked for; the same display for the same answer.
struct DisplayKey {
  EGLenum platform;        // EGL_NONE: X11 where there is a server, or no window system
  void *native = nullptr;  // an Xlib Display *, or null
  EGLint screen = -1;      // below 0: the default one
  bool operator==(const DisplayKey &) const = default;
};

struct Display {
  DisplayKey key;
  bool initialized = false;
  bool watched = false;                // we are told when the program closes the native display
  bool nativeClosed = false;           // it did: the pointer of the key means nothing, or something else, from now on
  std::shared_ptr<Platform> platform;  // null until it is needed, or without a window system
  HandleTable<Surface> surfaces;
  HandleTable<RenderContext> contexts;
  HandleTable<Sync> syncs;
  HandleTable<Image> images;

  // Connects on first use; null without a window system.
  std::shared_ptr<Platform> connect();
  // What its configs have in common.
  NativeTraits traits();
};

// Never removed.
Display *displayFor(const DisplayKey &key);
// Null for handles that are no display.
Display *findDisplay(EGLDisplay handle);

// Whether a context's handle is one of some other display.
bool belongsToAnotherDisplay(const Display &display, EGLContext context);

// EGL calls of all threads change displays one after the other. What takes long is not done under this lock: tracing,
// waiting for the trace of a context that shares objects, for a window to appear, for a file to be written. Opening a
// connection to the X server is, and so are short questions to it.
ForkMutex &displayMutex();

}  // namespace rc::egl
