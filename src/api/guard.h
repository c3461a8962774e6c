// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// guard.h: what every rc* function begins and ends with: find the context, let no exception out.
#pragma once

#include <exception>
#include <new>

#include "api/context.h"

namespace rc::api {

// Calls without a context do nothing, but rcGetError then tells. One flag a thread.
void noteMissingContext();
RCenum takeMissingContext();

// Runs body(context); returns its result, or a zero where there is no context or memory.
template <class Body>
auto enter(const char *function, Body &&body) noexcept -> decltype(body(std::declval<Context &>())) {
  using Result = decltype(body(std::declval<Context &>()));
  Context *context = currentContext();
  if (!context) {
    noteMissingContext();
    return Result();
  }
  try {
    const std::lock_guard lock(context->objects().mutex);
    context->enterFunction(function);
    return body(*context);
  } catch (const std::bad_alloc &) {
    context->fail(RC_OUT_OF_MEMORY, "there is not enough memory");
  } catch (const std::exception &error) {
    context->fail(RC_INVALID_OPERATION, "%s", error.what());
  }
  return Result();
}

}  // namespace rc::api
