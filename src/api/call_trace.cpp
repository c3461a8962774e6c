// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/call_trace.h"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

#include "api/functions.h"
#include "api/tokens.h"
#include "base/fork.h"
#include "base/settings.h"

namespace rc::api {
namespace {

// The file of RAYCORE_TRACE; null where there is none. It lives until the process ends.
std::FILE *traceFile() {
  static std::FILE *const file = [] {
    const std::string &name = settings().trace;
    if (name.empty()) return static_cast<std::FILE *>(nullptr);
    std::FILE *opened = name == "-" ? stderr : std::fopen(name.c_str(), "w");
    if (!opened) {
      log(LogLevel::Warning, "RAYCORE_TRACE=%s cannot be written: %s", name.c_str(), std::strerror(errno));
      return opened;
    }
    std::setvbuf(opened, nullptr, _IOLBF, 1 << 12);  // what was written stays if the program crashes
    return opened;
  }();
  return file;
}

// Type and name of the i-th parameter: "RCenum" and "light" out of "(RCenum light, ...)".
struct Parameter {
  std::string_view type, name;
};
Parameter parameterOf(std::string_view parameters, size_t i) {
  parameters = parameters.substr(1, parameters.size() - 2);
  for (; i > 0; --i) {
    const size_t comma = parameters.find(", ");
    if (comma == std::string_view::npos) return {};
    parameters.remove_prefix(comma + 2);
  }
  const std::string_view one = parameters.substr(0, parameters.find(", "));
  const size_t name = one.find_last_of(" *") + 1;
  return {one.substr(0, one.find_last_not_of(' ', name - 1) + 1), one.substr(name)};
}

// The shortest text that gives the same number again, as a float if it is one.
std::string number(double value) {
  char text[32];
  const auto narrow = static_cast<float>(value);
  const auto end = double(narrow) == value ? std::to_chars(text, std::end(text), narrow)
                                           : std::to_chars(text, std::end(text), value);
  return {text, end.ptr};
}

// Parameters of type RCint that carry a token, if the value is none of the small numbers they may also be.
bool carriesToken(std::string_view name, int64_t value) {
  return (name == "internalformat" || name == "param") && value >= 0x100;
}

struct Describe {
  std::string_view type, name;

  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(int64_t value) const {
    const auto token = static_cast<RCenum>(value);
    if (type.starts_with("RCenum")) return name.empty() ? errorName(token) : tokenName(token, name);
    if (type.starts_with("RCint") && carriesToken(name, value)) return tokenName(token, name);
    if (type.starts_with("RCboolean")) return value ? "RC_TRUE" : "RC_FALSE";
    if (type.starts_with("RCfixed") || type.starts_with("RCclampx")) return number(double(value) / 65536) + "x";
    return std::to_string(value);
  }
  std::string operator()(double value) const { return number(value); }
  std::string operator()(const void *value) const {
    if (!value) return "NULL";
    char text[32];
    std::snprintf(text, sizeof text, "%p", value);
    return text;
  }
  std::string operator()(const char *value) const { return value ? '"' + std::string(value) + '"' : "NULL"; }
  std::string operator()(const std::vector<double> &values) const {
    std::string text = "{";
    const bool fixed = type.find("RCfixed") != std::string_view::npos;
    for (const double value : values) {
      if (text.size() > 1) text += ", ";
      text += fixed ? number(value / 65536) + "x" : number(value);
    }
    return text + "}";
  }
};

}  // namespace

bool tracing() { return traceFile() != nullptr; }

std::string describeCall(const char *function, const std::vector<Traced> &arguments, const Outcome &outcome) {
  const FunctionRow *row = findFunction(function);
  const std::string_view parameters = row ? row->parameters : "()";
  std::string line = outcome.frame == 0 ? "no context: " : "frame " + std::to_string(outcome.frame) + ": ";
  line += std::string(function) + "(";
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter parameter = parameterOf(parameters, i);
    if (i > 0) line += ", ";
    line += std::string(parameter.name) + " = ";
    line += std::visit(Describe{parameter.type, parameter.name}, arguments[i]);
  }
  line += ")";
  const std::string result = std::visit(Describe{row ? row->result : "", ""}, outcome.result);
  if (!result.empty()) line += " = " + result;
  if (outcome.error != RC_NO_ERROR) line += std::string(": ") + errorName(outcome.error) + ": " + outcome.reason;
  return line;
}

void traceCall(const char *function, const std::vector<Traced> &arguments, const Outcome &outcome) {
  traceLine(describeCall(function, arguments, outcome));
}

void traceLine(const std::string &line) {
  static auto &mutex = *new ForkMutex;
  const std::lock_guard lock(mutex);
  std::fprintf(traceFile(), "%s\n", line.c_str());
}

}  // namespace rc::api
