// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What every text of an error must say. EXPECT_RAISES asks for it at each error of each function.
#include <cctype>

#include "api/context_fixture.h"
#include "api/functions.h"
#include "api/tokens.h"
#include "common/expressions.h"

namespace rc::test {
namespace {

bool isOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Names of parameters out of "(RCenum light, const RCfloat *params)": the last word before each comma and the end.
std::vector<std::string> parameterNames(std::string_view parameters) {
  std::vector<std::string> names;
  for (size_t end = parameters.find_first_of(",)"); end != std::string_view::npos;
       end = parameters.find_first_of(",)", end + 1)) {
    size_t last = end;
    while (last > 0 && parameters[last - 1] == ']') last = parameters.rfind('[', last - 1);  // an array's length
    size_t first = last;
    while (first > 0 && isOfName(parameters[first - 1])) --first;
    if (first < last) names.emplace_back(parameters.substr(first, last - first));
  }
  return names;
}

// Twins share their texts: "param" stands for "params" and the other way round, "target" for "env".
bool namesOne(const std::string &reason, const std::vector<std::string> &names) {
  return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
    const std::string one = name == "env" ? "target" : name == "params" ? "param" : name;
    return matches(reason, "(^|[^A-Za-z0-9_])" + one + "s?[ ,]");
  });
}

}  // namespace

std::string ContextTest::flawOfText(RCenum error) const {
  const size_t colon = message.find(": ");
  const api::FunctionRow *row = api::findFunction(message.substr(0, colon));
  if (!row) return "no function in: " + message;
  const std::string expected = std::string(row->name) + ": " + api::errorName(error) + ": ";
  if (!message.starts_with(expected)) return "not '" + expected + "': " + message;
  const bool refused = error == RC_INVALID_ENUM || error == RC_INVALID_VALUE;
  if (refused && !namesOne(message.substr(expected.size()), parameterNames(row->parameters))) {
    return "no argument of " + std::string(row->parameters) + " in: " + message;
  }
  return "";
}

}  // namespace rc::test
