// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: texture environment and texture units. Mode and colour belong to the bound material, as its texture
// does; the combiner is kept without effect. [spec 3.4; OpenGL ES 1.1, 3.7.12]
#include "RC/rc.h"
#include "api/guard.h"
#include "api/parameter_table.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = ParameterRow::Kind;
using Values = ParameterValues;

constexpr auto kIsSource = oneOf<RC_TEXTURE, RC_CONSTANT, RC_PRIMARY_COLOR, RC_PREVIOUS>;
constexpr auto kIsColourOperand = oneOf<RC_SRC_COLOR, RC_ONE_MINUS_SRC_COLOR, RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA>;
constexpr auto kIsAlphaOperand = oneOf<RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA>;

RCenum isScale(const Values &v) { return v[0] == 1 || v[0] == 2 || v[0] == 4 ? RC_NO_ERROR : RC_INVALID_VALUE; }

// A row for a token, or a number, of CombineState.
template <auto Member>
constexpr ParameterRow combineRow(RCenum name, RCenum (*check)(const Values &)) {
  using Type = std::remove_reference_t<decltype(std::declval<CombineState>().*Member)>;
  return {RC_TEXTURE_ENV,
          name,
          std::is_same_v<Type, float> ? Kind::Number : Kind::Token,
          1,
          check,
          [](Context &c, const Values &v) { c.state.combine.*Member = Type(v[0]); },
          [](const Context &c) { return Values{double(c.state.combine.*Member)}; }};
}

// A row for argument `Index` of the combiner.
template <auto Member, size_t Index>
constexpr ParameterRow argumentRow(RCenum name, RCenum (*check)(const Values &)) {
  return {RC_TEXTURE_ENV,
          name,
          Kind::Token,
          1,
          check,
          [](Context &c, const Values &v) { (c.state.combine.*Member)[Index] = RCenum(v[0]); },
          [](const Context &c) { return Values{double((c.state.combine.*Member)[Index])}; }};
}

using Combine = CombineState;
constexpr ParameterRow kTextureEnv[] = {
    {RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, Kind::Token, 1,
     oneOf<RC_REPLACE, RC_MODULATE, RC_DECAL, RC_BLEND, RC_ADD, RC_COMBINE>,
     [](Context &c, const Values &v) { c.boundMaterial().textureEnvMode = RCenum(v[0]); },
     [](const Context &c) { return Values{double(c.boundMaterial().textureEnvMode)}; }},
    {RC_TEXTURE_ENV, RC_TEXTURE_ENV_COLOR, Kind::Colour, 4, anyValue,
     [](Context &c, const Values &v) { c.boundMaterial().textureEnvColor = toVec4(v); },
     [](const Context &c) { return fromVec4(c.boundMaterial().textureEnvColor); }},
    combineRow<&Combine::rgb>(
        RC_COMBINE_RGB,
        oneOf<RC_REPLACE, RC_MODULATE, RC_ADD, RC_ADD_SIGNED, RC_INTERPOLATE, RC_SUBTRACT, RC_DOT3_RGB, RC_DOT3_RGBA>),
    combineRow<&Combine::alpha>(RC_COMBINE_ALPHA,
                                oneOf<RC_REPLACE, RC_MODULATE, RC_ADD, RC_ADD_SIGNED, RC_INTERPOLATE, RC_SUBTRACT>),
    combineRow<&Combine::rgbScale>(RC_RGB_SCALE, isScale),
    combineRow<&Combine::alphaScale>(RC_ALPHA_SCALE, isScale),
    argumentRow<&Combine::sourceRgb, 0>(RC_SRC0_RGB, kIsSource),
    argumentRow<&Combine::sourceRgb, 1>(RC_SRC1_RGB, kIsSource),
    argumentRow<&Combine::sourceRgb, 2>(RC_SRC2_RGB, kIsSource),
    argumentRow<&Combine::sourceAlpha, 0>(RC_SRC0_ALPHA, kIsSource),
    argumentRow<&Combine::sourceAlpha, 1>(RC_SRC1_ALPHA, kIsSource),
    argumentRow<&Combine::sourceAlpha, 2>(RC_SRC2_ALPHA, kIsSource),
    argumentRow<&Combine::operandRgb, 0>(RC_OPERAND0_RGB, kIsColourOperand),
    argumentRow<&Combine::operandRgb, 1>(RC_OPERAND1_RGB, kIsColourOperand),
    argumentRow<&Combine::operandRgb, 2>(RC_OPERAND2_RGB, kIsColourOperand),
    argumentRow<&Combine::operandAlpha, 0>(RC_OPERAND0_ALPHA, kIsAlphaOperand),
    argumentRow<&Combine::operandAlpha, 1>(RC_OPERAND1_ALPHA, kIsAlphaOperand),
    argumentRow<&Combine::operandAlpha, 2>(RC_OPERAND2_ALPHA, kIsAlphaOperand),
    {RC_POINT_SPRITE_OES, RC_COORD_REPLACE_OES, Kind::Switch, 1, anyValue,
     [](Context &c, const Values &v) { c.state.combine.coordReplace = v[0] != 0; },
     [](const Context &c) { return Values{double(c.state.combine.coordReplace)}; }},
};

int countOf(RCenum target, RCenum pname) { return parameterCount(kTextureEnv, target, pname); }

void setUnit(Context &context, RCenum &unit, RCenum texture) {
  if (texture != RC_TEXTURE0)
    return context.fail(RC_INVALID_ENUM, "texture 0x%04X is not RC_TEXTURE0, the only unit", texture);
  unit = texture;
}

}  // namespace

extern "C" {

void rcTexEnvf(RCenum target, RCenum pname, RCfloat param) {
  enter(Call("rcTexEnvf", target, pname, param),
        [&](Context &c) { setScalarParameter(c, kTextureEnv, target, pname, param); });
}

void rcTexEnvi(RCenum target, RCenum pname, RCint param) {
  enter(Call("rcTexEnvi", target, pname, param),
        [&](Context &c) { setScalarParameter(c, kTextureEnv, target, pname, param); });
}

void rcTexEnvx(RCenum target, RCenum pname, RCfixed param) {
  enter(Call("rcTexEnvx", target, pname, param),
        [&](Context &c) { setScalarParameter(c, kTextureEnv, target, pname, Fixed{param}); });
}

void rcTexEnvfv(RCenum target, RCenum pname, const RCfloat *params) {
  enter(Call("rcTexEnvfv", target, pname, list(params, [&] { return countOf(target, pname); })),
        [&](Context &c) { setParameters<RCfloat>(c, kTextureEnv, target, pname, params); });
}

void rcTexEnviv(RCenum target, RCenum pname, const RCint *params) {
  enter(Call("rcTexEnviv", target, pname, list(params, [&] { return countOf(target, pname); })),
        [&](Context &c) { setParameters<RCint>(c, kTextureEnv, target, pname, params); });
}

void rcTexEnvxv(RCenum target, RCenum pname, const RCfixed *params) {
  enter(Call("rcTexEnvxv", target, pname, list(params, [&] { return countOf(target, pname); })),
        [&](Context &c) { setParameters<Fixed>(c, kTextureEnv, target, pname, params); });
}

void rcGetTexEnvfv(RCenum env, RCenum pname, RCfloat *params) {
  enter(Call("rcGetTexEnvfv", env, pname, params),
        [&](Context &c) { getParameters<RCfloat>(c, kTextureEnv, env, pname, params); });
}

void rcGetTexEnviv(RCenum env, RCenum pname, RCint *params) {
  enter(Call("rcGetTexEnviv", env, pname, params),
        [&](Context &c) { getParameters<RCint>(c, kTextureEnv, env, pname, params); });
}

void rcGetTexEnvxv(RCenum env, RCenum pname, RCfixed *params) {
  enter(Call("rcGetTexEnvxv", env, pname, params),
        [&](Context &c) { getParameters<Fixed>(c, kTextureEnv, env, pname, params); });
}

void rcActiveTexture(RCenum texture) {
  enter(Call("rcActiveTexture", texture), [&](Context &c) { setUnit(c, c.state.texture.activeUnit, texture); });
}

void rcClientActiveTexture(RCenum texture) {
  enter(Call("rcClientActiveTexture", texture),
        [&](Context &c) { setUnit(c, c.state.texture.clientActiveUnit, texture); });
}

}  // extern "C"
