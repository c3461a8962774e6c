// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// query.h: the table behind rcGetBooleanv, rcGetFixedv, rcGetFloatv and rcGetIntegerv. [reference 4.11]
#pragma once

#include <array>

#include "api/context.h"

namespace rc::api {

struct QueryResult {
  enum class Kind {
    Number,  // counts and measures
    Colour,  // 0 ... 1 each channel; in integers 0 ... 255
    Switch,  // 0 or 1
    Token,   // never scaled
  };

  Kind kind = Kind::Number;
  int count = 0;  // values written; 0: no such name
  std::array<double, 16> values{};
};

QueryResult query(Context &context, RCenum pname);

}  // namespace rc::api
