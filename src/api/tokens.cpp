// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/tokens.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iterator>

namespace rc::api {
namespace {

struct TokenRow {
  RCenum value;
  const char *name;
};

constexpr TokenRow kTokens[] = {
#define RC_TOKEN(name) {name, #name},
#include "api/token_names.inc"
#undef RC_TOKEN
};

constexpr const char *kPrimitives[] = {"RC_POINTS",    "RC_LINES",          "RC_LINE_LOOP",    "RC_LINE_STRIP",
                                       "RC_TRIANGLES", "RC_TRIANGLE_STRIP", "RC_TRIANGLE_FAN", "RC_QUADS"};

}  // namespace

const char *errorName(RCenum error) {
  if (error == RC_NO_ERROR) return "RC_NO_ERROR";
  for (const TokenRow &row : kTokens) {
    if (row.value == error) return row.name;
  }
  return "an unknown error";
}

std::string tokenName(RCenum value, std::string_view parameter) {
  if (value < std::size(kPrimitives)) {
    if (parameter == "mode") return kPrimitives[value];
    if (parameter == "sfactor" || parameter == "dfactor") return value == RC_ZERO ? "RC_ZERO" : "RC_ONE";
    if (parameter.empty()) return errorName(value);  // a result: that of rcGetError
    return std::to_string(value);
  }
  if (value >= RC_LIGHT0 && value <= RC_LIGHT1023) return "RC_LIGHT" + std::to_string(value - RC_LIGHT0);
  for (const TokenRow &row : kTokens) {
    if (row.value == value) return row.name;
  }
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", value);
  return text;
}

std::string withTokenNames(std::string_view text) {
  constexpr std::string_view kPrefix = "0x";
  std::string named;
  for (size_t at = 0; at < text.size();) {
    const size_t start = std::min(text.find(kPrefix, at), text.size());
    named += text.substr(at, start - at);
    if (start == text.size()) break;
    RCenum value = 0;
    const char *digits = text.data() + start + kPrefix.size();
    const auto [end, error] = std::from_chars(digits, text.data() + text.size(), value, 16);
    const size_t length = size_t(end - (text.data() + start));
    const bool isToken = error == std::errc() && value >= std::size(kPrimitives);
    named += isToken ? tokenName(value, "") : std::string(text.substr(start, length));
    at = start + length;
  }
  return named;
}

}  // namespace rc::api
