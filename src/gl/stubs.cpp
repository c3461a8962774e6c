// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The vendor's library also exports the names of OpenGL ES 1.1, with empty bodies, and a program that was linked
// against it may ask for them. Ours are empty too, with one difference: where a library behind ours has the function,
// it is called, so that RayCore beside a real OpenGL ES takes nothing away. [reference 1.7]
#include <dlfcn.h>

#include "RC/rctypes.h"

using Text = const RCubyte *;

// Looks for the other library's function at the first call.
#define GL_FUNCTION(result, name, parameters, arguments)                                      \
  __attribute__((visibility("default"))) result name parameters {                             \
    static const auto next = reinterpret_cast<result(*) parameters>(dlsym(RTLD_NEXT, #name)); \
    return next ? next arguments : result();                                                  \
  }

extern "C" {
#include "gl/functions.inc"
}
