// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/brightness.h"

#include <vector>

#include "rcddk/nearest.h"
#include "rchal/units/tolerance.h"

namespace rc::ddk {
namespace {

using namespace rc::hal;

// What is left of a light where it is strongest, on the surface next to it.
float mostThatArrives(const SceneView &scene, const LightRow &light) {
  if (light.directional) return 1;
  if (light.constant == 0 && light.linear == 0 && light.quadratic == 0) return 1;
  if (light.constant < 0 || light.linear < 0 || light.quadratic < 0) return kInfinity;
  float distance = kInfinity;
  for (const GeometryView &geometry : scene.geometry) {
    distance = std::min(distance, nearestSurface(geometry, light.position));
  }
  if (distance == kInfinity) return 0;  // there is nothing to shine on
  // Less what positions and distances are rounded by.
  distance = std::max(0.0f, distance * (1 - 1e-3f) - 0x1p-20f * maxComponent(glm::abs(light.position)));
  return 1 / (light.constant + distance * (light.linear + distance * light.quadratic));
}

// What a surface sends out by itself, and of what lights bring. Texels may take the place of ambient and diffuse;
// colours of vertices are at most 1.
float ownLight(const SceneView &scene, const MaterialRow &row, std::span<const float> arriving) {
  const float texel = row.texture == kNoTexture ? 0 : std::max(1.0f, maxComponent(row.textureEnvColor));
  const float ambient = std::max(texel, maxComponent(row.ambient)),
              diffuse = std::max(texel, maxComponent(row.diffuse));
  float sum = maxComponent(row.emission) + ambient * maxComponent(scene.globalAmbient);
  for (size_t i = 0; i < arriving.size(); ++i) {
    const LightRow &light = scene.lights[i];
    const float colour = ambient * maxComponent(light.ambient) + diffuse * maxComponent(light.diffuse) +
                         maxComponent(row.specular) * maxComponent(light.specular);
    if (colour > 0) sum += colour * arriving[i];
  }
  return sum;
}

}  // namespace

float brightest(const SceneView &scene) {
  std::vector<float> arriving;
  for (const LightRow &light : scene.lights) {
    const bool lit =
        maxComponent(light.ambient) > 0 || maxComponent(light.diffuse) > 0 || maxComponent(light.specular) > 0;
    arriving.push_back(lit ? mostThatArrives(scene, light) : 0);
  }
  float most = std::max({1.0f, maxComponent(scene.clearColor), maxComponent(scene.fog.color)});
  const auto add = [&](std::span<const MaterialRow> rows) {
    for (const MaterialRow &row : rows) most = std::max(most, ownLight(scene, row, arriving));
  };
  add(scene.materials);
  for (const GeometryView &geometry : scene.geometry) add(geometry.captured);
  return most;
}

float ignorable(const SceneView &scene) { return kStep / brightest(scene); }

}  // namespace rc::ddk
