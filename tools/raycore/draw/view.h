// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// view.h: where the viewer is.
#pragma once

#include <optional>
#include <string>

#include "scene/pose.h"

namespace rc::tool {

struct View {
  Vec3 eye{0, 0, 1}, centre{0}, up{0, 1, 0};
  bool orthographic = false;
  float fov = 45;        // degrees, vertical
  float halfHeight = 1;  // orthographic
};

// The angle from which a framing camera looks: degrees round the up axis from the front, degrees above.
struct Angle {
  float azimuth = 30, elevation = 20;
};

// All of the bounds in the picture. Flat things are looked at from their front, unless the angle is given.
View framing(const Bounds &bounds, float aspect, float fov, bool zUp, const std::optional<Angle> &angle);

// A camera of the file, by number or name. Throws InputError: there is none such.
View fromFile(const Scene &scene, const Pose &pose, const std::string &camera);

// Where in its pixel a picture's sample lies, as a share of the picture's width and height.
using Shift = Vec2;

// Eye and unit direction of the ray through a place of the picture, 0 ... 1 from the lower left.
struct Sight {
  Vec3 from, direction;
};
Sight sightThrough(const View &view, float aspect, const Vec2 &place);

void setView(const View &view, float aspect, const Shift &shift = Shift(0));

}  // namespace rc::tool
