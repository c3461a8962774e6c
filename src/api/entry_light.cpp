// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: lights. [spec 3.3; G 4]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/light_parameters.h"

using namespace rc;
using namespace rc::api;

namespace {

// The light and the parameter, or an error and nulls.
struct Found {
  ddk::Light *light = nullptr;
  const LightParameter *parameter = nullptr;
};

Found find(Context &context, RCenum light, RCenum pname) {
  std::vector<ddk::Light> &lights = context.state.light.lights;
  if (light < RC_LIGHT0 || light - RC_LIGHT0 >= lights.size()) {
    context.fail(RC_INVALID_ENUM, "light 0x%04X is not RC_LIGHT0 ... %zu", light, lights.size() - 1);
    return {};
  }
  const LightParameter *parameter = findLightParameter(pname);
  if (!parameter) {
    context.fail(RC_INVALID_ENUM,
                 "pname 0x%04X is no parameter of lights (a colour, RC_POSITION, RC_SPOT_*, RC_*_ATTENUATION)", pname);
    return {};
  }
  return {&lights[light - RC_LIGHT0], parameter};
}

void set(Context &context, const Found &found, const float *values) {
  if (!validLightValues(*found.parameter, values)) {
    return context.fail(RC_INVALID_VALUE, "params is %g for pname 0x%04X, not %s", values[0], found.parameter->name,
                        allowedLightValues(*found.parameter));
  }
  setLightValues(*found.parameter, values, context.state.matrices.modelview.current(), *found.light);
  context.touch();
}

void setScalar(Context &context, RCenum light, RCenum pname, float value) {
  const Found found = find(context, light, pname);
  if (!found.light) return;
  if (found.parameter->reads != 1) {
    return context.fail(RC_INVALID_ENUM, "pname 0x%04X has several values; rcLightfv sets them", pname);
  }
  set(context, found, &value);
}

}  // namespace

extern "C" {

void rcLightf(RCenum light, RCenum pname, RCfloat param) {
  enter(Call("rcLightf", light, pname, param), [&](Context &context) { setScalar(context, light, pname, param); });
}

void rcLightx(RCenum light, RCenum pname, RCfixed param) {
  enter(Call("rcLightx", light, pname, param),
        [&](Context &context) { setScalar(context, light, pname, fromFixed(param)); });
}

void rcLightfv(RCenum light, RCenum pname, const RCfloat *params) {
  enter(Call("rcLightfv", light, pname, list(params, [&] { return lightValueCount(pname); })), [&](Context &context) {
    const Found found = find(context, light, pname);
    if (!found.light) return;
    if (!params) return context.fail(RC_INVALID_VALUE, "params is NULL, not a pointer to values");
    set(context, found, params);
  });
}

void rcLightxv(RCenum light, RCenum pname, const RCfixed *params) {
  enter(Call("rcLightxv", light, pname, list(params, [&] { return lightValueCount(pname); })), [&](Context &context) {
    const Found found = find(context, light, pname);
    if (!found.light) return;
    if (!params) return context.fail(RC_INVALID_VALUE, "params is NULL, not a pointer to values");
    float values[4] = {};
    std::transform(params, params + found.parameter->reads, values, [](RCfixed value) { return fromFixed(value); });
    set(context, found, values);
  });
}

void rcGetLightfv(RCenum light, RCenum pname, RCfloat *params) {
  enter(Call("rcGetLightfv", light, pname, params), [&](Context &context) {
    const Found found = find(context, light, pname);
    if (found.light && params) std::copy_n(found.parameter->values(*found.light), found.parameter->writes, params);
  });
}

void rcGetLightxv(RCenum light, RCenum pname, RCfixed *params) {
  enter(Call("rcGetLightxv", light, pname, params), [&](Context &context) {
    const Found found = find(context, light, pname);
    if (!found.light || !params) return;
    const float *values = found.parameter->values(*found.light);
    std::transform(values, values + found.parameter->writes, params, [](float value) { return toFixed(value); });
  });
}

}  // extern "C"
