// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/camera.h"

#include <algorithm>
#include <cmath>

namespace rc::tool {
namespace {

constexpr float kHighest = glm::radians(89.5f);
constexpr float kNotch = 0.9f;     // of the distance that a notch of the wheel leaves
constexpr float kNearest = 1e-3f;  // radii
constexpr float kRadiiASecond = 1.2f;

}  // namespace

void CameraController::place(const View &view, const Bounds &bounds, bool zUp) {
  mView = view;
  mRadius = std::max(bounds.radius(), 1e-6f);
  mPole = zUp ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  mFront = zUp ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
  mSide = glm::cross(mPole, mFront);
}

CameraController::Turn CameraController::turnOf(const Vec3 &back) const {
  const float height = std::clamp(glm::dot(back, mPole), -1.0f, 1.0f);
  Vec3 level = back - height * mPole;
  if (glm::length(level) < 1e-3f) level = height > 0 ? -mView.up : mView.up;  // straight from a pole
  return {std::atan2(glm::dot(level, mSide), glm::dot(level, mFront)), std::asin(height)};
}

Vec3 CameraController::backOf(const Turn &turn) const {
  return std::cos(turn.elevation) * (std::sin(turn.azimuth) * mSide + std::cos(turn.azimuth) * mFront) +
         std::sin(turn.elevation) * mPole;
}

Vec3 CameraController::turned(float across, float up) const {
  Turn turn = turnOf(glm::normalize(mView.eye - mView.centre));
  turn.azimuth += across;
  turn.elevation = std::clamp(turn.elevation + up, -kHighest, kHighest);
  return backOf(turn) * glm::length(mView.eye - mView.centre);
}

void CameraController::orbit(float across, float up) {
  mView.eye = mView.centre + turned(across, up);
  mView.up = mPole;
}

void CameraController::look(float across, float up) {
  mView.centre = mView.eye - turned(across, up);
  mView.up = mPole;
}

void CameraController::pan(float right, float up) {
  const float distance = glm::length(mView.eye - mView.centre);
  const float height = 2 * (mView.orthographic ? mView.halfHeight : distance * std::tan(glm::radians(mView.fov) / 2));
  move(height * (right * this->right() + up * this->up()));
}

void CameraController::zoom(float steps) {
  const float factor = std::pow(kNotch, steps);
  const Vec3 way = mView.eye - mView.centre;
  const float distance = std::max(glm::length(way) * factor, kNearest * mRadius);
  mView.eye = mView.centre + glm::normalize(way) * distance;
  mView.halfHeight *= factor;
}

void CameraController::fly(const Vec3 &way, float seconds) {
  const Vec3 forward = glm::normalize(mView.centre - mView.eye);
  move(kRadiiASecond * mRadius * seconds * (way.x * right() + way.y * up() + way.z * forward));
}

void CameraController::move(const Vec3 &way) {
  mView.eye += way;
  mView.centre += way;
}

}  // namespace rc::tool
