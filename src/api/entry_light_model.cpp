// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: light model. [spec 3.3; OpenGL ES 1.1, 2.12.1]
#include "RC/rc.h"
#include "api/guard.h"
#include "api/parameter_table.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = ParameterRow::Kind;
using Values = ParameterValues;

constexpr ParameterRow kLightModel[] = {
    {0, RC_LIGHT_MODEL_AMBIENT, Kind::Colour, 4, anyValue,
     [](Context &c, const Values &v) { c.state.light.modelAmbient = toVec4(v); }, nullptr},
    {0, RC_LIGHT_MODEL_TWO_SIDE, Kind::Switch, 1, anyValue,
     [](Context &c, const Values &v) { c.state.light.twoSide = v[0] != 0; }, nullptr},
};

}  // namespace

extern "C" {

void rcLightModelf(RCenum pname, RCfloat param) {
  enter(Call("rcLightModelf", pname, param), [&](Context &c) { setScalarParameter(c, kLightModel, 0, pname, param); });
}

void rcLightModelfv(RCenum pname, const RCfloat *params) {
  enter(Call("rcLightModelfv", pname, list(params, [&] { return parameterCount(kLightModel, 0, pname); })),
        [&](Context &c) { setParameters<RCfloat>(c, kLightModel, 0, pname, params); });
}

void rcLightModelx(RCenum pname, RCfixed param) {
  enter(Call("rcLightModelx", pname, param),
        [&](Context &c) { setScalarParameter(c, kLightModel, 0, pname, Fixed{param}); });
}

void rcLightModelxv(RCenum pname, const RCfixed *params) {
  enter(Call("rcLightModelxv", pname, list(params, [&] { return parameterCount(kLightModel, 0, pname); })),
        [&](Context &c) { setParameters<Fixed>(c, kLightModel, 0, pname, params); });
}

}  // extern "C"
