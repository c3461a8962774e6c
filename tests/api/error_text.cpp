// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What every text of an error must say. EXPECT_RAISES asks for it at each error of each function.
#include <regex>

#include "api/context_fixture.h"
#include "api/functions.h"
#include "api/tokens.h"

namespace rc::test {
namespace {

// Names of parameters out of "(RCenum light, const RCfloat *params)".
std::vector<std::string> parameterNames(std::string_view parameters) {
  static const std::regex kName("([A-Za-z_0-9]+)(\\[[0-9]+\\])?[,)]");
  const std::string text(parameters);
  std::vector<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), kName), end; at != end; ++at) names.push_back((*at)[1]);
  return names;
}

// Twins share their texts: "param" stands for "params" and the other way round, "target" for "env".
bool namesOne(const std::string &reason, const std::vector<std::string> &names) {
  return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
    const std::string one = name == "env" ? "target" : name == "params" ? "param" : name;
    return std::regex_search(reason, std::regex("\\b" + one + "s?[ ,]"));
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
