// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/material_parameters.h"

#include <algorithm>

namespace rc::api {
namespace {

using ddk::Material;
using Kind = MaterialParameter::Kind;

constexpr MaterialParameter kParameters[] = {
    {RC_AMBIENT, Kind::Colour, [](Material &m) { return &m.ambient; }, nullptr},
    {RC_AMBIENT_AND_DIFFUSE, Kind::Colour, [](Material &m) { return &m.ambient; }, nullptr},
    {RC_DIFFUSE, Kind::Colour, [](Material &m) { return &m.diffuse; }, nullptr},
    {RC_SPECULAR, Kind::Colour, [](Material &m) { return &m.specular; }, nullptr},
    {RC_EMISSION, Kind::Colour, [](Material &m) { return &m.emission; }, nullptr},
    {RC_REFLECTION, Kind::Share, [](Material &m) { return &m.reflection; }, nullptr},
    {RC_TRANSMITTANCE, Kind::Share, [](Material &m) { return &m.transmittance; }, nullptr},
    {RC_SHININESS, Kind::Scalar, nullptr, [](Material &m) { return &m.shininess; }},
    {RC_SPECULAR_LEVEL, Kind::Scalar, nullptr, [](Material &m) { return &m.specularLevel; }},
    {RC_ROUGHNESS, Kind::Scalar, nullptr, [](Material &m) { return &m.roughness; }},
    {RC_REFRACTION_INDEX, Kind::Scalar, nullptr, [](Material &m) { return &m.refractionIndex; }},
};

}  // namespace

const MaterialParameter *findMaterialParameter(RCenum name) {
  const auto *found = std::find_if(std::begin(kParameters), std::end(kParameters),
                                   [&](const MaterialParameter &parameter) { return parameter.name == name; });
  return found == std::end(kParameters) ? nullptr : found;
}

}  // namespace rc::api
