// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The vendor's library also exports the names of OpenGL ES 1.1, with empty bodies, and a program that was linked
// against it may ask for them. Ours are empty too, with one difference: where a library behind ours has the function,
// it is called, so that RayCore beside a real OpenGL ES takes nothing away. [reference 1.7]
#include <dlfcn.h>

#include <atomic>

#include "RC/rctypes.h"
#include "gl/functions.h"

using Text = const RCubyte *;

namespace {

// The other library's function, once there is one: it may be loaded at any time.
void *twinOf(std::atomic<void *> &known, const char *name) {
  void *twin = known.load(std::memory_order_relaxed);
  if (!twin) known.store(twin = dlsym(RTLD_NEXT, name), std::memory_order_relaxed);
  return twin;
}

}  // namespace

#define GL_FUNCTION(result, name, parameters, arguments)                            \
  __attribute__((visibility("default"))) result name parameters {                   \
    static constinit std::atomic<void *> known = nullptr;                           \
    const auto next = reinterpret_cast<result(*) parameters>(twinOf(known, #name)); \
    return next ? next arguments : result();                                        \
  }

extern "C" {
#include "gl/functions.inc"
}
#undef GL_FUNCTION

namespace rc::gl {

std::span<const NamedFunction> functions() {
#define GL_FUNCTION(result, name, parameters, arguments) {#name, reinterpret_cast<void (*)()>(name)},
  static const NamedFunction kFunctions[] = {
#include "gl/functions.inc"
  };
#undef GL_FUNCTION
  return kFunctions;
}

}  // namespace rc::gl
