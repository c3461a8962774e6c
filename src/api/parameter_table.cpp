// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/parameter_table.h"

#include <algorithm>
#include <cstdio>

namespace rc::api {
namespace {

const ParameterRow *find(std::span<const ParameterRow> table, RCenum target, RCenum name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ParameterRow &row) { return row.target == target && row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

// The value as a message shows it: withTokenNames makes names of hexadecimal numbers.
std::string describe(const ParameterRow &row, double value) {
  char text[32];
  if (row.kind == ParameterRow::Kind::Token && value >= 0 && value <= double(UINT32_MAX)) {
    std::snprintf(text, sizeof text, "0x%04X", static_cast<RCenum>(value));
  } else {
    std::snprintf(text, sizeof text, "%g", value);
  }
  return text;
}

}  // namespace

const ParameterRow *findParameter(Context &context, std::span<const ParameterRow> table, RCenum target, RCenum name) {
  const ParameterRow *row = find(table, target, name);
  if (!row) {
    const bool targetKnown = std::any_of(table.begin(), table.end(), [&](const auto &r) { return r.target == target; });
    context.fail(RC_INVALID_ENUM,
                 targetKnown ? "pname 0x%04X is no parameter of this call" : "target 0x%04X is no target of this call",
                 targetKnown ? name : target);
  }
  return row;
}

int parameterCount(std::span<const ParameterRow> table, RCenum target, RCenum name) {
  const ParameterRow *row = find(table, target, name);
  return row ? row->count : 0;
}

void setParameter(Context &context, const ParameterRow &row, ParameterValues values) {
  if (row.kind == ParameterRow::Kind::Token) values[0] = roundToInt(values[0]);
  if (row.kind == ParameterRow::Kind::Colour) {
    for (double &value : values) value = double(clamp01(float(value)));
  }
  const auto isNumber = [](double value) { return std::isfinite(value); };
  if (!std::all_of(values.begin(), values.end(), isNumber)) {
    return context.fail(RC_INVALID_VALUE, "params of pname 0x%04X are not all finite", row.name);
  }
  const RCenum error = row.check(values);
  if (error != RC_NO_ERROR)
    return context.fail(error, "params is %s for pname 0x%04X: not one of its values", describe(row, values[0]).c_str(),
                        row.name);
  row.set(context, values);
  context.touch();
}

}  // namespace rc::api
