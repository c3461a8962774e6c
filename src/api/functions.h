// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// functions.h: the table of functions.inc as data.
#pragma once

#include <span>
#include <string_view>

namespace rc::api {

enum class Effect { Acts, Stored, Accepted };

struct FunctionRow {
  std::string_view result, name;
  std::string_view parameters;  // "(RCenum light, RCenum pname, RCfloat param)"
  Effect effect;
  std::string_view source, errors, note;
};

std::span<const FunctionRow> functions();

// Null for names that are none.
const FunctionRow *findFunction(std::string_view name);

}  // namespace rc::api
