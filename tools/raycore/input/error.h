// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// error.h: what is wrong with an input, or with the command line. The command ends with one line of it.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace rc::tool {

// "place: what"; the file's name comes before it. Exit code 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Options that cannot be meant, whatever the files hold. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class... Arguments>
[[noreturn]] void reject(fmt::format_string<Arguments...> text, Arguments &&...arguments) {
  throw InputError(fmt::format(text, std::forward<Arguments>(arguments)...));
}

template <class... Arguments>
[[noreturn]] void refuseOption(fmt::format_string<Arguments...> text, Arguments &&...arguments) {
  throw UsageError(fmt::format(text, std::forward<Arguments>(arguments)...));
}

}  // namespace rc::tool
