// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/light_parameters.h"

#include <algorithm>

#include "api/convert.h"

namespace rc::api {
namespace {

using ddk::Light;
using Rule = LightParameter::Rule;

constexpr LightParameter kParameters[] = {
    {RC_AMBIENT, 3, 4, Rule::Colour, [](Light &l) { return &l.ambient.x; }},
    {RC_DIFFUSE, 3, 4, Rule::Colour, [](Light &l) { return &l.diffuse.x; }},
    {RC_SPECULAR, 3, 4, Rule::Colour, [](Light &l) { return &l.specular.x; }},
    {RC_POSITION, 4, 4, Rule::Position, [](Light &l) { return &l.position.x; }},
    {RC_SPOT_DIRECTION, 3, 3, Rule::Direction, [](Light &l) { return &l.spotDirection.x; }},
    {RC_SPOT_EXPONENT, 1, 1, Rule::NotNegative, [](Light &l) { return &l.spotExponent; }},
    {RC_SPOT_INNER_CONE, 1, 1, Rule::Cone, [](Light &l) { return &l.innerCone; }},
    {RC_SPOT_OUTER_CONE, 1, 1, Rule::Cone, [](Light &l) { return &l.outerCone; }},
    {RC_SPOT_CUTOFF, 1, 1, Rule::Cone, [](Light &l) { return &l.outerCone; }},
    {RC_ATTENUATION_RANGE, 2, 2, Rule::NotNegative, [](Light &l) { return l.attenuationRange; }},
    {RC_START_ATTENUATION, 1, 1, Rule::NotNegative, [](Light &l) { return &l.attenuationRange[0]; }},
    {RC_END_ATTENUATION, 1, 1, Rule::NotNegative, [](Light &l) { return &l.attenuationRange[1]; }},
    {RC_CONSTANT_ATTENUATION, 1, 1, Rule::NotNegative, [](Light &l) { return &l.constant; }},
    {RC_LINEAR_ATTENUATION, 1, 1, Rule::NotNegative, [](Light &l) { return &l.linear; }},
    {RC_QUADRATIC_ATTENUATION, 1, 1, Rule::NotNegative, [](Light &l) { return &l.quadratic; }},
};

}  // namespace

const LightParameter *findLightParameter(RCenum name) {
  const auto *found = std::find_if(std::begin(kParameters), std::end(kParameters),
                                   [&](const LightParameter &parameter) { return parameter.name == name; });
  return found == std::end(kParameters) ? nullptr : found;
}

bool validLightValues(const LightParameter &parameter, const float *values) {
  return std::all_of(values, values + parameter.reads, [&](float value) {
    switch (parameter.rule) {
      case Rule::NotNegative:
        return value >= 0;
      case Rule::Cone:
        return (value >= 0 && value <= 90) || value == ddk::kNoCone;
      default:
        return true;
    }
  });
}

const char *allowedLightValues(const LightParameter &parameter) {
  return parameter.rule == Rule::Cone ? "0 ... 90 degrees or 180" : "0 or more";
}

void setLightValues(const LightParameter &parameter, const float *values, const Mat4 &worldFromObject, Light &light) {
  switch (parameter.rule) {
    case Rule::Position:
      // Any w but 0 means a point, which the whole matrix moves; w itself is kept as it was given.
      light.position = worldFromObject * Vec4(values[0], values[1], values[2], values[3] != 0 ? 1.0f : 0.0f);
      light.position.w = values[3];
      return;
    case Rule::Direction:
      light.spotDirection = Vec3(worldFromObject * Vec4(values[0], values[1], values[2], 0));
      return;
    case Rule::Colour:
      std::transform(values, values + 3, parameter.values(light), [](float value) { return clamp01(value); });
      return;
    default:
      std::copy_n(values, parameter.reads, parameter.values(light));
  }
}

}  // namespace rc::api
