// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// expressions.h: extended regular expressions of the C library; std::regex does not compile without warnings under
// GCC 12 with sanitizers.
#pragma once

#include <gtest/gtest.h>
#include <regex.h>

#include <string>

namespace rc::test {

// Whether a part of the text matches.
inline bool matches(const std::string &text, const std::string &expression) {
  regex_t compiled;
  EXPECT_EQ(regcomp(&compiled, expression.c_str(), REG_EXTENDED | REG_NOSUB), 0) << expression;
  const bool found = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  regfree(&compiled);
  return found;
}

}  // namespace rc::test
