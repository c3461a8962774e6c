// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry point: functions by name. [spec 5; EGL 1.5, 3.11]
#include <cstring>

#include "RC/rcu.h"
#include "egl/entry.h"
#include "egl/vendor_calls.h"

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

Function find(std::span<const NamedFunction> rows, const char *name) {
  for (const NamedFunction &row : rows) {
    if (!std::strcmp(row.name, name)) return row.function;
  }
  return nullptr;
}

}  // namespace

extern "C" {

// What old programs ask for, eglGetElapsedTime, is not here: an answer overflows a buffer of theirs. [reference 1.6]
__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char *name) {
  if (!name) return nullptr;
  const Function entry = find(entryFunctions(), name);
  return entry ? entry : find(extensionFunctions(), name);
}

}  // extern "C"
