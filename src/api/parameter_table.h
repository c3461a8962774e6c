// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// parameter_table.h: families of GL parameters that are set by name, as one or several values of one of three types:
// fog, light model, texture environment, points. A family is a table; these functions are what rcFogf ... rcFogxv,
// rcTexEnvf ... do with it. [OpenGL ES 1.1, 2.6.1, 6.1.2]
#pragma once

#include <array>
#include <span>

#include "api/context.h"
#include "api/convert.h"

namespace rc::api {

using ParameterValues = std::array<double, 4>;

struct ParameterRow {
  enum class Kind {
    Number,
    Colour,  // four values, clamped to 0 ... 1; integers span the range of their type
    Token,   // never scaled
    Switch,  // 0 is off
  };

  RCenum target;  // 0 where the family has no targets
  RCenum name;
  Kind kind;
  int count;
  // RC_NO_ERROR, or the error that these values raise.
  RCenum (*check)(const ParameterValues &values);
  void (*set)(Context &context, const ParameterValues &values);
  ParameterValues (*get)(const Context &context);  // null where the family has no gets
};

// The row, or RC_INVALID_ENUM and null.
const ParameterRow *findParameter(Context &context, std::span<const ParameterRow> table, RCenum target, RCenum name);

// The number of values that a call reads; 0 for unknown names. For the tracer.
int parameterCount(std::span<const ParameterRow> table, RCenum target, RCenum name);

// Checks, clamps and sets.
void setParameter(Context &context, const ParameterRow &row, ParameterValues values);

// A value of the API as a number, and back.
inline double parameterFrom(ParameterRow::Kind, float value) { return double(value); }
inline double parameterFrom(ParameterRow::Kind kind, RCint value) {
  return kind == ParameterRow::Kind::Colour ? (2.0 * value + 1) / 4294967295.0 : double(value);
}
inline void parameterTo(ParameterRow::Kind, double value, float &result) { result = static_cast<float>(value); }
inline void parameterTo(ParameterRow::Kind kind, double value, RCint &result) {
  result = kind == ParameterRow::Kind::Colour ? toSpannedInt(value) : roundToInt(value);
}

// RCfixed and RCint are one type in C: fixed-point calls wrap their values.
struct Fixed {
  RCfixed value;
};
inline double parameterFrom(ParameterRow::Kind kind, Fixed fixed) {
  return kind == ParameterRow::Kind::Token ? double(fixed.value) : double(fromFixed(fixed.value));
}
inline void parameterTo(ParameterRow::Kind kind, double value, Fixed &result) {
  result.value = kind == ParameterRow::Kind::Token ? static_cast<RCfixed>(value) : toFixed(value);
}

// rcFogf and the like: one value; parameters of several values raise RC_INVALID_ENUM.
template <class Value>
void setScalarParameter(Context &context, std::span<const ParameterRow> table, RCenum target, RCenum name,
                        Value value) {
  const ParameterRow *row = findParameter(context, table, target, name);
  if (!row) return;
  if (row->count != 1)
    return context.fail(RC_INVALID_ENUM, "pname 0x%04X has %d values; the call for vectors sets them", name,
                        row->count);
  setParameter(context, *row, {parameterFrom(row->kind, value)});
}

// rcFogfv and the like. Value is the type the values are read as: Fixed for RCfixed.
template <class Value, class Given>
void setParameters(Context &context, std::span<const ParameterRow> table, RCenum target, RCenum name,
                   const Given *params) {
  const ParameterRow *row = findParameter(context, table, target, name);
  if (!row || !params) return;
  ParameterValues values{};
  for (size_t i = 0; i < size_t(row->count); ++i) values[i] = parameterFrom(row->kind, Value{params[i]});
  setParameter(context, *row, values);
}

template <class Value, class Given>
void getParameters(Context &context, std::span<const ParameterRow> table, RCenum target, RCenum name, Given *params) {
  const ParameterRow *row = findParameter(context, table, target, name);
  if (!row || !params) return;
  const ParameterValues values = row->get(context);
  for (size_t i = 0; i < size_t(row->count); ++i) {
    Value value{};
    parameterTo(row->kind, values[i], value);
    if constexpr (std::is_same_v<Value, Fixed>) {
      params[i] = value.value;
    } else {
      params[i] = value;
    }
  }
}

// Checks that several families share.
inline RCenum anyValue(const ParameterValues &) { return RC_NO_ERROR; }
inline RCenum notNegative(const ParameterValues &values) { return values[0] >= 0 ? RC_NO_ERROR : RC_INVALID_VALUE; }

// Whether the first value is one of the tokens.
template <RCenum... Tokens>
RCenum oneOf(const ParameterValues &values) {
  return ((values[0] == Tokens) || ...) ? RC_NO_ERROR : RC_INVALID_ENUM;
}

inline Vec4 toVec4(const ParameterValues &values) {
  return {float(values[0]), float(values[1]), float(values[2]), float(values[3])};
}
inline ParameterValues fromVec4(const Vec4 &values) { return {values.x, values.y, values.z, values.w}; }

}  // namespace rc::api
