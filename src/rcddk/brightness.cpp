// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/brightness.h"

#include "rcddk/nearest.h"

namespace rc::ddk {
namespace {

using namespace rc::hal;

// The largest values of the materials; texels may take the place of ambient and diffuse.
struct Surfaces {
  float ambient = 1, diffuse = 1, specular = 0, emission = 0;

  void add(std::span<const MaterialRow> rows) {
    for (const MaterialRow &row : rows) {
      ambient = std::max(ambient, maxComponent(row.ambient));
      diffuse = std::max(diffuse, maxComponent(row.diffuse));
      specular = std::max(specular, maxComponent(row.specular));
      emission = std::max(emission, maxComponent(row.emission));
    }
  }
};

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

}  // namespace

float brightest(const SceneView &scene) {
  Surfaces surfaces;
  surfaces.add(scene.materials);
  for (const GeometryView &geometry : scene.geometry) surfaces.add(geometry.captured);
  float most = surfaces.emission + surfaces.ambient * maxComponent(scene.globalAmbient);
  for (const LightRow &light : scene.lights) {
    const float onSurface = surfaces.ambient * maxComponent(light.ambient) +
                            surfaces.diffuse * maxComponent(light.diffuse) +
                            surfaces.specular * maxComponent(light.specular);
    if (onSurface > 0) most += onSurface * mostThatArrives(scene, light);
  }
  return std::max({1.0f, most, maxComponent(scene.clearColor), maxComponent(scene.fog.color)});
}

}  // namespace rc::ddk
