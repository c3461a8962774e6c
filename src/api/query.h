// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// query.h: the table behind rcGetBooleanv, rcGetFixedv, rcGetFloatv and rcGetIntegerv. [reference 4.11]
#pragma once

#include <array>
#include <span>

#include "api/context.h"

namespace rc::api {

struct QueryResult {
  enum class Kind {
    Number,   // counts and measures
    Colour,   // 0 ... 1 each channel; in integers 0 ... 255 [reference 4.11]
    Clamped,  // 0 ... 1; in integers 0 ... 2^31 - 1, as in GL
    Switch,   // 0 or 1
    Token,    // never scaled
  };

  Kind kind = Kind::Number;
  int count = 0;  // values written; 0: no such name
  std::array<double, 16> values{};
};

QueryResult query(Context &context, RCenum pname);

// How one name is answered: `count` values are written.
struct QueryRow {
  RCenum name;
  QueryResult::Kind kind;
  int count;
  void (*read)(const Context &context, double *values);
};

// Names of OpenGL ES 1.1 that RayCore's own state does not have; query_raster.cpp.
std::span<const QueryRow> rasterQueries();
std::span<const QueryRow> statisticsQueries();

inline void writeColour(const Vec4 &colour, double *values) {
  for (int i = 0; i < 4; ++i) values[i] = double(colour[i]);
}
inline void writeColour(const Rgb &colour, double *values) { writeColour(Vec4(colour, 1), values); }

// A row whose value never changes.
template <int Value>
void constant(const Context &, double *values) {
  values[0] = Value;
}

}  // namespace rc::api
