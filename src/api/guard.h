// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// guard.h: what every rc* function begins and ends with: find the context, let no exception out, tell the tracer.
#pragma once

#include <exception>
#include <new>

#include "api/call_trace.h"
#include "api/context.h"
#include "base/float_mode.h"
#include "base/memory.h"

namespace rc::api {

// Calls without a context do nothing, but rcGetError then tells. One flag a thread.
void noteMissingContext();
RCenum takeMissingContext();

// Runs body(context) under the lock of the share group; its result, or a zero where there is no memory.
template <class Body>
auto guarded(const char *function, Context &context, Body &&body) noexcept -> decltype(body(context)) {
  const FloatMode mode;
  try {
    const std::lock_guard lock(context.objects().mutex);
    context.enterFunction(function);
    return body(context);
  } catch (const MemoryRefused &refused) {
    context.fail(RC_OUT_OF_MEMORY, "%s", refused.what());
  } catch (const std::bad_alloc &) {
    context.fail(RC_OUT_OF_MEMORY, "there is not enough memory");
  } catch (const std::exception &error) {
    context.fail(RC_INVALID_OPERATION, "%s", error.what());
  }
  return decltype(body(context))();
}

// The same with the tracer on.
template <class... Arguments, class Body>
auto guardedAndTraced(const Call<Arguments...> &call, Context &context, Body &&body) noexcept
    -> decltype(body(context)) {
  Outcome outcome{.frame = context.frameNumber()};
  const auto finish = [&] {
    const Failure &failure = context.failure();
    outcome.error = failure.error;
    outcome.reason = failure.reason.c_str();
    traceCall(call, outcome);
  };
  if constexpr (std::is_void_v<decltype(body(context))>) {
    guarded(call.function, context, body);
    finish();
  } else {
    const auto result = guarded(call.function, context, body);
    outcome.result = traced(result);
    finish();
    return result;
  }
}

template <class... Arguments, class Body>
auto enter(const Call<Arguments...> &call, Body &&body) noexcept -> decltype(body(std::declval<Context &>())) {
  Context *context = currentContext();
  if (!context) {
    noteMissingContext();
    if (tracing()) traceCall(call, {.error = RC_INVALID_OPERATION, .reason = "there is no current context"});
    return decltype(body(*context))();
  }
  return tracing() ? guardedAndTraced(call, *context, body) : guarded(call.function, *context, body);
}

}  // namespace rc::api
