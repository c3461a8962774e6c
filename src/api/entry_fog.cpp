// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: fog. [spec 3.8; OpenGL ES 1.1, 3.8]
#include "RC/rc.h"
#include "api/guard.h"
#include "api/parameter_table.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = ParameterRow::Kind;
using Values = ParameterValues;

constexpr ParameterRow kFog[] = {
    {0, RC_FOG_MODE, Kind::Token, 1, oneOf<RC_LINEAR, RC_EXP, RC_EXP2>,
     [](Context &c, const Values &v) { c.state.fog.mode = RCenum(v[0]); }, nullptr},
    {0, RC_FOG_DENSITY, Kind::Number, 1, notNegative,
     [](Context &c, const Values &v) { c.state.fog.density = float(v[0]); }, nullptr},
    {0, RC_FOG_START, Kind::Number, 1, anyValue, [](Context &c, const Values &v) { c.state.fog.start = float(v[0]); },
     nullptr},
    {0, RC_FOG_END, Kind::Number, 1, anyValue, [](Context &c, const Values &v) { c.state.fog.end = float(v[0]); },
     nullptr},
    {0, RC_FOG_COLOR, Kind::Colour, 4, anyValue, [](Context &c, const Values &v) { c.state.fog.color = toVec4(v); },
     nullptr},
};

}  // namespace

extern "C" {

void rcFogf(RCenum pname, RCfloat param) {
  enter(Call("rcFogf", pname, param), [&](Context &c) { setScalarParameter(c, kFog, 0, pname, param); });
}

void rcFogfv(RCenum pname, const RCfloat *params) {
  enter(Call("rcFogfv", pname, list(params, [&] { return parameterCount(kFog, 0, pname); })),
        [&](Context &c) { setParameters<RCfloat>(c, kFog, 0, pname, params); });
}

void rcFogx(RCenum pname, RCfixed param) {
  enter(Call("rcFogx", pname, param), [&](Context &c) { setScalarParameter(c, kFog, 0, pname, Fixed{param}); });
}

void rcFogxv(RCenum pname, const RCfixed *params) {
  enter(Call("rcFogxv", pname, list(params, [&] { return parameterCount(kFog, 0, pname); })),
        [&](Context &c) { setParameters<Fixed>(c, kFog, 0, pname, params); });
}

}  // extern "C"
