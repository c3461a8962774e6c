// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: state that only rasterisation has: checked, kept and returned, without effect on rays. [spec 3.8]
#include <algorithm>

#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/parameter_table.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = ParameterRow::Kind;
using Values = ParameterValues;

// Whether the token is in a range of consecutive ones; else RC_INVALID_ENUM.
bool checkToken(Context &context, const char *argument, RCenum token, RCenum first, RCenum last) {
  if (token >= first && token <= last) return true;
  context.fail(RC_INVALID_ENUM, "%s 0x%04X is not one of 0x%04X ... 0x%04X", argument, token, first, last);
  return false;
}

bool isComparison(Context &context, RCenum func) { return checkToken(context, "func", func, RC_NEVER, RC_ALWAYS); }

bool isSourceFactor(RCenum f) {
  return f == RC_ZERO || f == RC_ONE || (f >= RC_SRC_ALPHA && f <= RC_SRC_ALPHA_SATURATE);
}
bool isDestinationFactor(RCenum f) {
  return f == RC_ZERO || f == RC_ONE || (f >= RC_SRC_COLOR && f <= RC_ONE_MINUS_DST_ALPHA);
}

bool isStencilOperation(RCenum op) { return op == RC_ZERO || op == RC_INVERT || (op >= RC_KEEP && op <= RC_DECR); }

void setBlendFunc(Context &context, RCenum source, RCenum destination) {
  if (!isSourceFactor(source) || !isDestinationFactor(destination)) {
    return context.fail(RC_INVALID_ENUM,
                        "sfactor 0x%04X and dfactor 0x%04X are not a factor of the source and one of the destination",
                        source, destination);
  }
  context.state.raster.blendSource = source;
  context.state.raster.blendDestination = destination;
}

void setStencilOp(Context &context, RCenum fail, RCenum depthFail, RCenum depthPass) {
  if (!isStencilOperation(fail) || !isStencilOperation(depthFail) || !isStencilOperation(depthPass)) {
    return context.fail(RC_INVALID_ENUM,
                        "fail 0x%04X, zfail 0x%04X, zpass 0x%04X: one is not RC_KEEP, RC_ZERO, RC_REPLACE, RC_INCR, "
                        "RC_DECR or RC_INVERT",
                        fail, depthFail, depthPass);
  }
  RasterState &raster = context.state.raster;
  raster.stencilFail = fail;
  raster.stencilDepthFail = depthFail;
  raster.stencilDepthPass = depthPass;
}

// Widths and sizes are above 0.
void setSize(Context &context, const char *argument, float RasterState::*member, float size) {
  if (!(size > 0)) return context.fail(RC_INVALID_VALUE, "%s is %g, not above 0", argument, size);
  context.state.raster.*member = size;
}

void setDepthRange(Context &context, float zNear, float zFar) {
  context.state.raster.depthNear = clamp01(zNear);
  context.state.raster.depthFar = clamp01(zFar);
}

void setPolygonOffset(Context &context, float factor, float units) {
  context.state.raster.polygonOffsetFactor = factor;
  context.state.raster.polygonOffsetUnits = units;
}

void setSampleCoverage(Context &context, float value, bool invert) {
  context.state.raster.coverageValue = clamp01(value);
  context.state.raster.coverageInvert = invert;
}

template <float RasterState::*Member>
void setPoint(Context &context, const Values &values) {
  context.state.raster.*Member = float(values[0]);
}

RCenum threeNotNegative(const Values &v) {
  return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 ? RC_NO_ERROR : RC_INVALID_VALUE;
}

constexpr ParameterRow kPoints[] = {
    {0, RC_POINT_SIZE_MIN, Kind::Number, 1, notNegative, setPoint<&RasterState::pointSizeMin>, nullptr},
    {0, RC_POINT_SIZE_MAX, Kind::Number, 1, notNegative, setPoint<&RasterState::pointSizeMax>, nullptr},
    {0, RC_POINT_FADE_THRESHOLD_SIZE, Kind::Number, 1, notNegative, setPoint<&RasterState::pointFadeThreshold>,
     nullptr},
    {0, RC_POINT_DISTANCE_ATTENUATION, Kind::Number, 3, threeNotNegative,
     [](Context &c, const Values &v) { c.state.raster.pointAttenuation = Vec3(toVec4(v)); }, nullptr},
};

}  // namespace

extern "C" {

void rcBlendFunc(RCenum sfactor, RCenum dfactor) {
  enter(Call("rcBlendFunc", sfactor, dfactor), [&](Context &context) { setBlendFunc(context, sfactor, dfactor); });
}

void rcLogicOp(RCenum opcode) {
  enter(Call("rcLogicOp", opcode), [&](Context &context) {
    if (checkToken(context, "opcode", opcode, RC_CLEAR, RC_SET)) context.state.raster.logicOp = opcode;
  });
}

void rcDepthFunc(RCenum func) {
  enter(Call("rcDepthFunc", func), [&](Context &context) {
    if (isComparison(context, func)) context.state.raster.depthFunc = func;
  });
}

void rcDepthMask(RCboolean flag) {
  enter(Call("rcDepthMask", flag), [&](Context &context) { context.state.raster.depthMask = flag != 0; });
}

void rcDepthRangef(RCclampf zNear, RCclampf zFar) {
  enter(Call("rcDepthRangef", zNear, zFar), [&](Context &context) { setDepthRange(context, zNear, zFar); });
}

void rcDepthRangex(RCclampx zNear, RCclampx zFar) {
  enter(Call("rcDepthRangex", zNear, zFar),
        [&](Context &context) { setDepthRange(context, fromFixed(zNear), fromFixed(zFar)); });
}

void rcClearDepthf(RCclampf depth) {
  enter(Call("rcClearDepthf", depth), [&](Context &context) { context.state.raster.clearDepth = clamp01(depth); });
}

void rcClearDepthx(RCclampx depth) {
  enter(Call("rcClearDepthx", depth),
        [&](Context &context) { context.state.raster.clearDepth = clamp01(fromFixed(depth)); });
}

void rcClearStencil(RCint s) {
  enter(Call("rcClearStencil", s), [&](Context &context) { context.state.raster.clearStencil = s; });
}

void rcStencilFunc(RCenum func, RCint ref, RCuint mask) {
  enter(Call("rcStencilFunc", func, ref, mask), [&](Context &context) {
    if (!isComparison(context, func)) return;
    context.state.raster.stencilFunc = func;
    context.state.raster.stencilRef = ref;
    context.state.raster.stencilValueMask = mask;
  });
}

void rcStencilMask(RCuint mask) {
  enter(Call("rcStencilMask", mask), [&](Context &context) { context.state.raster.stencilWriteMask = mask; });
}

void rcStencilOp(RCenum fail, RCenum zfail, RCenum zpass) {
  enter(Call("rcStencilOp", fail, zfail, zpass), [&](Context &context) { setStencilOp(context, fail, zfail, zpass); });
}

void rcLineWidth(RCfloat width) {
  enter(Call("rcLineWidth", width),
        [&](Context &context) { setSize(context, "width", &RasterState::lineWidth, width); });
}

void rcLineWidthx(RCfixed width) {
  enter(Call("rcLineWidthx", width),
        [&](Context &context) { setSize(context, "width", &RasterState::lineWidth, fromFixed(width)); });
}

void rcPointSize(RCfloat size) {
  enter(Call("rcPointSize", size), [&](Context &context) { setSize(context, "size", &RasterState::pointSize, size); });
}

void rcPointSizex(RCfixed size) {
  enter(Call("rcPointSizex", size),
        [&](Context &context) { setSize(context, "size", &RasterState::pointSize, fromFixed(size)); });
}

void rcPointParameterf(RCenum pname, RCfloat param) {
  enter(Call("rcPointParameterf", pname, param), [&](Context &c) { setScalarParameter(c, kPoints, 0, pname, param); });
}

void rcPointParameterx(RCenum pname, RCfixed param) {
  enter(Call("rcPointParameterx", pname, param),
        [&](Context &c) { setScalarParameter(c, kPoints, 0, pname, Fixed{param}); });
}

void rcPointParameterfv(RCenum pname, const RCfloat *params) {
  enter(Call("rcPointParameterfv", pname, list(params, [&] { return parameterCount(kPoints, 0, pname); })),
        [&](Context &c) { setParameters<RCfloat>(c, kPoints, 0, pname, params); });
}

void rcPointParameterxv(RCenum pname, const RCfixed *params) {
  enter(Call("rcPointParameterxv", pname, list(params, [&] { return parameterCount(kPoints, 0, pname); })),
        [&](Context &c) { setParameters<Fixed>(c, kPoints, 0, pname, params); });
}

void rcPolygonOffset(RCfloat factor, RCfloat units) {
  enter(Call("rcPolygonOffset", factor, units), [&](Context &context) { setPolygonOffset(context, factor, units); });
}

void rcPolygonOffsetx(RCfixed factor, RCfixed units) {
  enter(Call("rcPolygonOffsetx", factor, units),
        [&](Context &context) { setPolygonOffset(context, fromFixed(factor), fromFixed(units)); });
}

void rcSampleCoverage(RCclampf value, RCboolean invert) {
  enter(Call("rcSampleCoverage", value, invert),
        [&](Context &context) { setSampleCoverage(context, value, invert != 0); });
}

void rcSampleCoveragex(RCclampx value, RCboolean invert) {
  enter(Call("rcSampleCoveragex", value, invert),
        [&](Context &context) { setSampleCoverage(context, fromFixed(value), invert != 0); });
}

}  // extern "C"
