// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/view.h"

#include <RC/rc.h>
#include <RC/rcu.h>

#include <charconv>
#include <cmath>

#include "input/error.h"

namespace rc::tool {
namespace {

constexpr float kMargin = 1.06f;
constexpr float kFlat = 0.02f;  // thinner than this share of its size is a picture, not a body

Vec3 directionOf(const Angle &angle, bool zUp) {
  const float a = glm::radians(angle.azimuth), e = glm::radians(angle.elevation);
  const Vec3 d(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
  return zUp ? Vec3(d.x, -d.z, d.y) : d;
}

Angle angleFor(const Bounds &bounds, bool zUp) {
  const Vec3 size = bounds.size();
  const float depth = zUp ? size.y : size.z, height = zUp ? size.z : size.y;
  if (depth < kFlat * maxOf(size)) return {0, 0};
  if (height < kFlat * maxOf(size)) return {0, 60};
  return {};
}

int indexOf(const Scene &scene, const std::string &camera) {
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    if (scene.cameras[i].name == camera) return static_cast<int>(i);
  }
  size_t index = 0;
  const auto [end, error] = std::from_chars(camera.data(), camera.data() + camera.size(), index);
  const bool isNumber = error == std::errc() && end == camera.data() + camera.size();
  if (isNumber && index < scene.cameras.size()) return static_cast<int>(index);
  reject("--camera: no camera \"{}\", the file has {}", camera, scene.cameras.size());
}

}  // namespace

View framing(const Bounds &bounds, float aspect, float fov, bool zUp, const std::optional<Angle> &angle) {
  View view;
  view.fov = fov;
  view.up = zUp ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  view.centre = bounds.centre();
  const Vec3 back = directionOf(angle.value_or(angleFor(bounds, zUp)), zUp);
  if (std::abs(glm::dot(back, view.up)) > 0.999f) view.up = zUp ? Vec3(0, 1, 0) : Vec3(0, 0, -1);
  const Vec3 right = glm::normalize(glm::cross(view.up, back)), up = glm::cross(back, right);
  const float tanY = std::tan(glm::radians(fov) / 2), tanX = tanY * aspect;
  float distance = 1e-6f;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 half = 0.5f * bounds.size() * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const float x = std::abs(glm::dot(half, right)) / tanX, y = std::abs(glm::dot(half, up)) / tanY;
    distance = std::max(distance, glm::dot(half, back) + std::max(x, y) * kMargin);
  }
  view.eye = view.centre + distance * back;
  return view;
}

View fromFile(const Scene &scene, const Pose &pose, const std::string &camera) {
  const int index = indexOf(scene, camera);
  const Camera &lens = scene.cameras[size_t(index)];
  for (const int node : scene.order) {
    if (scene.nodes[size_t(node)].camera != index) continue;
    const Mat4 &world = pose.world[size_t(node)];
    View view;
    view.eye = Vec3(world[3]);
    view.centre = view.eye - glm::normalize(Vec3(world[2]));
    view.up = glm::normalize(Vec3(world[1]));
    view.orthographic = lens.orthographic;
    view.fov = glm::degrees(lens.yfov);
    view.halfHeight = std::abs(lens.ymag);
    return view;
  }
  reject("--camera: camera \"{}\" is nowhere in the scene", camera);
}

Sight sightThrough(const View &view, float aspect, const Vec2 &place) {
  const Vec3 back = glm::normalize(view.eye - view.centre), right = glm::normalize(glm::cross(view.up, back));
  const Vec3 up = glm::cross(back, right);
  const float h = view.orthographic ? view.halfHeight : std::tan(glm::radians(view.fov) / 2);
  const Vec2 at = (2.0f * place - 1.0f) * Vec2(h * aspect, h);
  const Vec3 across = at.x * right + at.y * up;
  if (view.orthographic) return {view.eye + across, -back};
  return {view.eye, glm::normalize(across - back)};
}

void setView(const View &view, float aspect, const Shift &shift) {
  rcuLookAt(view.eye.x, view.eye.y, view.eye.z, view.centre.x, view.centre.y, view.centre.z, view.up.x, view.up.y,
            view.up.z);
  constexpr float kNear = 0.1f;
  const float h = view.orthographic ? view.halfHeight : kNear * std::tan(glm::radians(view.fov) / 2), w = h * aspect;
  const float x = 2 * w * shift.x, y = 2 * h * shift.y;
  if (view.orthographic) {
    rcOrthof(x - w, x + w, y - h, y + h, 0, 1);
  } else {
    rcFrustumf(x - w, x + w, y - h, y + h, kNear, 100);
  }
}

}  // namespace rc::tool
