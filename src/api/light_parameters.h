// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// light_parameters.h: the table of what rcLight* sets and rcGetLight* reads. [spec 3.3; reference 4.4]
#pragma once

#include "RC/rctokens.h"
#include "RC/rctypes.h"
#include "rcddk/light.h"

namespace rc::api {

struct LightParameter {
  enum class Rule { Colour, Position, Direction, NotNegative, Cone };

  RCenum name;
  int reads;   // values that rcLightfv reads; 1: rcLightf sets it too
  int writes;  // values that rcGetLightfv writes
  Rule rule;
  float *(*values)(ddk::Light &light);
};

// Null for names that are no light parameter.
const LightParameter *findLightParameter(RCenum name);

// Values that a call with this name reads; 0 for names that are no light parameter.
inline int lightValueCount(RCenum name) {
  const LightParameter *parameter = findLightParameter(name);
  return parameter ? parameter->reads : 0;
}

// Whether the values keep the parameter's rule.
bool validLightValues(const LightParameter &parameter, const float *values);

// What the rule allows, for messages.
const char *allowedLightValues(const LightParameter &parameter);

// Stores values that keep the rule; positions and directions pass through the modelview matrix.
void setLightValues(const LightParameter &parameter, const float *values, const Mat4 &worldFromObject,
                    ddk::Light &light);

}  // namespace rc::api
