// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// functions.h: the gl* functions by name, for eglGetProcAddress.
#pragma once

#include <span>

namespace rc::gl {

struct NamedFunction {
  const char *name;
  void (*function)();
};
std::span<const NamedFunction> functions();

}  // namespace rc::gl
