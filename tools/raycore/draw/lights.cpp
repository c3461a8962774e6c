// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/lights.h"

#include <RC/rc.h>

#include <algorithm>
#include <cmath>

#include "input/error.h"

namespace rc::tool {
namespace {

constexpr int kMostLights = 8;
constexpr float kDistantRadii = 30;

void setColour(RCenum light, RCenum name, const Vec3 &c) {
  const float values[] = {c.x, c.y, c.z, 1};
  rcLightfv(light, name, values);
}

void setAmbient(float level) {
  const float values[] = {level, level, level, 1};
  rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, values);
}

// position.w 0: towards the light. Distant lights are points all the same, within a background's sphere: from beyond
// it their shadow rays would meet it.
RCenum addLight(int index, Vec4 position, const Vec3 &colour, const Bounds &bounds) {
  const RCenum light = RCenum(RC_LIGHT0 + index);
  if (position.w == 0)
    position = Vec4(bounds.centre() + kDistantRadii * std::max(bounds.radius(), 1e-6f) * Vec3(position), 1);
  const float place[] = {position.x, position.y, position.z, position.w};
  rcLightfv(light, RC_POSITION, place);
  setColour(light, RC_AMBIENT, Vec3(0));
  setColour(light, RC_DIFFUSE, colour);
  setColour(light, RC_SPECULAR, colour);
  rcLightf(light, RC_CONSTANT_ATTENUATION, 1);
  rcLightf(light, RC_LINEAR_ATTENUATION, 0);
  rcLightf(light, RC_QUADRATIC_ATTENUATION, 0);
  rcLightf(light, RC_SPOT_OUTER_CONE, 180);
  rcEnable(light);
  return light;
}

struct Studio {
  Vec3 right, up, back;
  Bounds bounds;

  Studio(const View &view, const Bounds &about) : bounds(about) {
    back = glm::normalize(view.eye - view.centre);
    right = glm::normalize(glm::cross(view.up, back));
    up = glm::cross(back, right);
  }
  void light(int index, const Vec3 &from, float level) const {
    addLight(index, Vec4(glm::normalize(from.x * right + from.y * up + from.z * back), 0), Vec3(level), bounds);
  }
};

void setStudio(const View &view, const Bounds &bounds) {
  const Studio studio(view, bounds);
  setAmbient(0.3f);
  studio.light(0, {-0.6f, 0.9f, 0.9f}, 0.65f);  // key
  studio.light(1, {0.9f, 0.2f, 0.7f}, 0.25f);   // fill
  studio.light(2, {0.2f, 0.6f, -1.0f}, 0.35f);  // rim
}

void setHeadlight(const View &view, const Bounds &bounds) {
  setAmbient(0.25f);
  Studio(view, bounds).light(0, {0.1f, 0.15f, 1}, 0.8f);
}

struct Placed {
  const Light *light;
  Vec3 position, direction;
  float level;  // light that arrives at the scene's middle, in the file's units
};

std::vector<Placed> lightsOf(const Scene &scene, const Pose &pose, const Bounds &bounds) {
  std::vector<Placed> result;
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    if (node.light < 0) continue;
    const Light &light = scene.lights[size_t(node.light)];
    const Mat4 &world = pose.world[size_t(index)];
    const Vec3 position(world[3]), direction = -glm::normalize(Vec3(world[2]));
    const float distance = std::max(glm::length(position - bounds.centre()), 0.25f * bounds.radius());
    const bool sun = light.kind == LightKind::Directional;
    result.push_back({&light, position, direction, light.intensity / (sun ? 1 : distance * distance)});
  }
  return result;
}

// Files measure in lux and candela, RayCore in shares of what a display shows: the brightest light at the scene's
// middle becomes 1, and the others keep their relation to it.
void place(int index, const Placed &placed, float brightest, const Bounds &bounds) {
  const Light &from = *placed.light;
  const Vec3 colour = encoded(from.color / std::max(maxOf(from.color), 1e-6f));
  if (from.kind == LightKind::Directional) {
    addLight(index, Vec4(-placed.direction, 0), colour * (placed.level / brightest), bounds);
    return;
  }
  const RCenum light = addLight(index, Vec4(placed.position, 1), colour, bounds);
  rcLightf(light, RC_CONSTANT_ATTENUATION, 0);
  rcLightf(light, RC_QUADRATIC_ATTENUATION, brightest / std::max(from.intensity, 1e-6f));
  if (from.kind != LightKind::Spot) return;
  const float direction[] = {placed.direction.x, placed.direction.y, placed.direction.z};
  rcLightfv(light, RC_SPOT_DIRECTION, direction);
  rcLightf(light, RC_SPOT_INNER_CONE, glm::degrees(from.innerCone));
  rcLightf(light, RC_SPOT_OUTER_CONE, std::min(glm::degrees(from.outerCone), 90.0f));
}

void setFileLights(Scene &scene, const std::vector<Placed> &lights, const Bounds &bounds) {
  if (lights.size() > kMostLights) {
    scene.note(fmt::format("{} lights: RayCore has {}; the first ones are used", lights.size(), kMostLights));
  }
  float brightest = 1e-20f;
  for (const Placed &placed : lights) brightest = std::max(brightest, placed.level);
  setAmbient(0.15f);
  for (size_t i = 0; i < lights.size() && i < kMostLights; ++i) place(int(i), lights[i], brightest, bounds);
}

}  // namespace

void setLights(Scene &scene, const Pose &pose, const View &view, const Bounds &bounds, Lighting lighting) {
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
  rcEnable(RC_LIGHTING);
  for (int i = 0; i < kMostLights; ++i) rcDisable(RCenum(RC_LIGHT0 + i));
  const std::vector<Placed> lights = lightsOf(scene, pose, bounds);
  if (lighting == Lighting::File && lights.empty()) reject("--lights file: the file has none");
  const bool fromFile = lighting == Lighting::File || (lighting == Lighting::Automatic && !lights.empty());
  if (fromFile) return setFileLights(scene, lights, bounds);
  if (lighting == Lighting::Headlight) return setHeadlight(view, bounds);
  if (lighting != Lighting::None) return setStudio(view, bounds);
  setAmbient(1);
  addLight(0, Vec4(0, 0, 1, 0), Vec3(0), bounds);  // none on at all would be the default light
}

}  // namespace rc::tool
