// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// functions.h: every function of the library, made from the tables that the library itself is made from, so that a new
// one is here as soon as it is there.
#pragma once

#include <span>

#include "calls/arguments.h"

namespace rc::fuzz {

struct Function {
  const char *name;
  void (*call)(const Site &site);
};

std::span<const Function> functions();

// What an input calls a function: the same when others come or go.
uint16_t codeOf(std::string_view name);
const Function &functionOf(uint16_t code);

// Those whose pointers come with sizes, or whose arguments could make a sound program wait or write for ever; they
// stand for the generic call. sized_calls.cpp, egl_calls.cpp
std::span<const Function> sizedCalls();
std::span<const Function> eglCalls();

}  // namespace rc::fuzz
