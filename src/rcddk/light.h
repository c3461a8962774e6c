// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// light.h: a light as the program sets it; position and direction are in world space. [spec 3.3; G 4]
#pragma once

#include "rchal/scene_view.h"

namespace rc::ddk {

inline constexpr float kNoCone = 180;  // an outer cone that is none: light in all directions

struct Light {
  Vec4 ambient{1, 1, 1, 0}, diffuse{0.1f, 0.1f, 0.1f, 0}, specular{0, 0, 0, 0};
  Vec4 position{0, 0, 1, 0};  // w = 0: a direction towards the light; never divided by w
  Vec3 spotDirection{0};
  float spotExponent = 0;
  float innerCone = 0, outerCone = kNoCone;  // half angles, degrees
  float attenuationRange[2] = {0, 0};        // start and end, world units
  float constant = 1, linear = 0, quadratic = 0;
  bool enabled = false;
};

inline hal::LightRow lightRow(const Light &light) {
  hal::LightRow row;
  row.directional = light.position.w == 0;
  row.position = row.directional ? normalizedOr(Vec3(light.position), {0, 0, 1}) : Vec3(light.position);
  row.ambient = Rgb(light.ambient);
  row.diffuse = Rgb(light.diffuse);
  row.specular = Rgb(light.specular);
  row.spot = !row.directional && light.spotDirection != Vec3(0) && light.outerCone != kNoCone;
  row.spotDirection = normalizedOr(light.spotDirection, {0, 0, -1});
  row.cosInner = std::cos(glm::radians(std::min(light.innerCone, light.outerCone)));
  row.cosOuter = std::cos(glm::radians(light.outerCone));
  row.spotExponent = light.spotExponent;
  row.constant = light.constant;
  row.linear = light.linear;
  row.quadratic = light.quadratic;
  row.rangeStart = light.attenuationRange[0];
  row.rangeEnd = light.attenuationRange[1];
  return row;
}

// What lights the scene when lighting is off or no light is on: the initial values as a point light,
// without shadow and highlight. [spec 3.3, 8]
inline hal::LightRow defaultLightRow(const Vec3 &position) {
  hal::LightRow row = lightRow(Light{});
  row.position = position;
  row.directional = false;
  row.castsShadow = false;
  row.specular = Rgb(0);
  return row;
}

}  // namespace rc::ddk
