// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material_parameters.h: the table of what rcMaterial* sets and rcGetMaterial* reads. [spec 3.5; reference 4.2]
#pragma once

#include "RC/rctokens.h"
#include "RC/rctypes.h"
#include "rcddk/material.h"

namespace rc::api {

struct MaterialParameter {
  enum class Kind {
    Colour,  // three values, clamped to 0 ... 1; through fv only
    Share,   // of light: through f one value for all channels, through fv three or, by profile, one
    Scalar,  // one value, not below 0
  };

  RCenum name;
  Kind kind;
  Rgb *(*colour)(ddk::Material &material);    // Colour, Share
  float *(*scalar)(ddk::Material &material);  // Scalar
};

// Null for names that are no material parameter. RC_AMBIENT_AND_DIFFUSE is found as RC_AMBIENT.
const MaterialParameter *findMaterialParameter(RCenum name);

// Values that a vector call with this name reads; 0 for names that are no material parameter.
inline int materialValueCount(RCenum name, bool colouredReflection) {
  const MaterialParameter *parameter = findMaterialParameter(name);
  if (!parameter) return 0;
  const bool single = parameter->kind == MaterialParameter::Kind::Scalar ||
                      (parameter->kind == MaterialParameter::Kind::Share && !colouredReflection);
  return single ? 1 : 3;
}

}  // namespace rc::api
