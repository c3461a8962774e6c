// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// call_trace.h: RAYCORE_TRACE=file logs each call: its frame, arguments by name, result, and the error it raised.
// While it is off a call costs one test of a flag. [spec 6; beyond the guide]
//
// A line:  frame 3: rcLightf(light = RC_LIGHT0, pname = RC_SPOT_CUTOFF, param = 95): RC_INVALID_VALUE: 95 is ...
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "RC/rctypes.h"

namespace rc::api {

// An argument that points to values, all of which the call reads. Count: a number, or a function that finds it and
// is asked only while tracing.
template <class Value, class Count>
struct List {
  const Value *values;
  Count count;

  int size() const {
    if constexpr (std::is_invocable_v<Count>) {
      return count();
    } else {
      return count;
    }
  }
};
template <class Value, class Count>
List<Value, Count> list(const Value *values, Count count) {
  return {values, count};
}

// A call: what it is named and what it was given, in the order of functions.inc.
template <class... Arguments>
struct Call {
  const char *function;
  std::tuple<Arguments...> arguments;

  explicit Call(const char *name, Arguments... given) : function(name), arguments(given...) {}
};

// An argument or a result as the tracer writes it.
using Traced = std::variant<std::monostate, int64_t, double, const void *, const char *, std::vector<double>>;

template <class Value>
Traced traced(const Value &value) {
  if constexpr (std::is_integral_v<Value>) {
    return static_cast<int64_t>(value);
  } else if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<double>(value);
  } else {
    return static_cast<const void *>(value);
  }
}
template <class Value, class Count>
Traced traced(const List<Value, Count> &list) {
  if (!list.values) return static_cast<const void *>(nullptr);
  return std::vector<double>(list.values, list.values + std::max(list.size(), 0));
}
inline Traced traced(const RCubyte *text) { return reinterpret_cast<const char *>(text); }

// What became of a call.
struct Outcome {
  uint64_t frame = 0;  // 0: there was no context
  Traced result;
  RCenum error = 0;
  const char *reason = "";
};

bool tracing();
void traceCall(const char *function, const std::vector<Traced> &arguments, const Outcome &outcome);
// A line of its own, for what is no call.
void traceLine(const std::string &line);

// The text of traceCall's line; a function of its own for the tests.
std::string describeCall(const char *function, const std::vector<Traced> &arguments, const Outcome &outcome);

template <class... Arguments>
void traceCall(const Call<Arguments...> &call, const Outcome &outcome) {
  const auto pack = [](const Arguments &...values) { return std::vector<Traced>{traced(values)...}; };
  try {
    traceCall(call.function, std::apply(pack, call.arguments), outcome);
  } catch (...) {  // out of memory: the line is missing, the program goes on
  }
}

}  // namespace rc::api
