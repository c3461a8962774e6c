// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// stage.h: what is about the model: background and ground.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace rc::tool {

enum class GroundKind { None, Matte, Mirror, Checker };

struct Background {
  Vec3 colour{0.18f, 0.2f, 0.23f};
  std::optional<Image> sphere;  // equirectangular, all about the scene
};

// "#rrggbb", "r,g,b" (0 ... 1), a colour's name, "gradient", "gradient:TOP,BOTTOM" (two #rrggbb), or a picture's file.
// Throws InputError.
Background backgroundFrom(const std::string &text);

class Stage {
 public:
  Stage(const Background &background, GroundKind ground, bool zUp);
  // Into the static scene that is open.
  void draw(const Bounds &bounds) const;
  // "background" or "ground", if the material is theirs.
  std::string materialName(unsigned name) const;

 private:
  void drawSphere(const Bounds &bounds) const;
  void drawGround(const Bounds &bounds) const;

  unsigned mSphere = 0, mGround = 0;
  bool mZUp;
};

}  // namespace rc::tool
