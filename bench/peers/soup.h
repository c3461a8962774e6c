// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// soup.h: the scenes of the measurements as triangles: nine floats each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace rc::bench {

struct Camera {
  Vec3 eye, at;
  float degrees;  // vertical
};

struct Soup {
  std::string name;
  std::vector<Vec3> vertices;  // three a triangle
  Camera camera;
  Vec3 light;

  size_t triangles() const { return vertices.size() / 3; }
};

// "cornell", "bunny", "sponza", "dragon203k", "dragon871k", "hills" and a number of triangles. Nothing if the scene's
// file is not in the folder of scenes; cornell and hills need none.
std::optional<Soup> loadSoup(const std::string &name, const std::string &folder);

}  // namespace rc::bench
