// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry point: functions by name. [spec 5; EGL 1.5, 3.11]
#include <cstring>

#include "RC/rcu.h"
#include "egl/entry.h"
#include "egl/vendor_calls.h"
#include "gl/functions.h"

using namespace rc;
using namespace rc::egl;

namespace {

using Function = __eglMustCastToProperFunctionPointerType;

// Made on first use: programs ask from constructors of globals.
std::span<const NamedFunction> entryFunctions() {
#define RC_ENTRY(entry) {#entry, reinterpret_cast<Function>(entry)},
#define RC_FUNCTION(result, name, ...) RC_ENTRY(name)
  static const NamedFunction kEntries[] = {
#include "api/functions.inc"
#include "egl/entry_points.inc"
  };
#undef RC_FUNCTION
#undef RC_ENTRY
  return kEntries;
}

template <class Row>
Function find(std::span<const Row> rows, const char *name) {
  for (const Row &row : rows) {
    if (!std::strcmp(row.name, name)) return row.function;
  }
  return nullptr;
}

}  // namespace

extern "C" {

// What old programs ask for, eglGetElapsedTime, is not here: an answer overflows a buffer of theirs. [reference 1.6]
__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char *name) {
  return enterUnlocked<Function>(nullptr, [&](ThreadState &) -> Function {
    if (!name) return nullptr;
    if (const Function entry = find(entryFunctions(), name)) return entry;
    if (const Function extension = find(extensionFunctions(), name)) return extension;
    return find(gl::functions(), name);
  });
}

}  // extern "C"
