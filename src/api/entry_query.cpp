// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: rcGet*v. [spec 3.8; reference 4.11]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/query.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = QueryResult::Kind;

template <class... Arguments, class Value, class Convert>
void get(const Call<Arguments...> &call, RCenum pname, Value *params, Convert &&convert) {
  enter(call, [&](Context &context) {
    const QueryResult result = query(context, pname);
    if (result.count == 0)
      return context.fail(RC_INVALID_ENUM, "pname 0x%04X is no state that can be asked for", pname);
    for (int i = 0; params && i < result.count; ++i) params[i] = convert(result.kind, result.values[size_t(i)]);
  });
}

}  // namespace

extern "C" {

void rcGetBooleanv(RCenum pname, RCboolean *params) {
  get(Call("rcGetBooleanv", pname, params), pname, params, [](Kind, double value) { return RCboolean(value != 0); });
}

void rcGetFixedv(RCenum pname, RCfixed *params) {
  get(Call("rcGetFixedv", pname, params), pname, params,
      [](Kind kind, double value) { return kind == Kind::Token ? roundToInt(value) : toFixed(value); });
}

void rcGetFloatv(RCenum pname, RCfloat *params) {
  get(Call("rcGetFloatv", pname, params), pname, params,
      [](Kind, double value) { return static_cast<RCfloat>(value); });
}

void rcGetIntegerv(RCenum pname, RCint *params) {
  get(Call("rcGetIntegerv", pname, params), pname, params, [](Kind kind, double value) {
    if (kind == Kind::Colour) return roundToInt(value * 255);
    if (kind == Kind::Clamped) return toSpannedInt(value);
    return roundToInt(value);
  });
}

}  // extern "C"
