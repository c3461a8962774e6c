// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scenes.h: the scenes of whole frames, as the renderers that they are compared with have them: the same triangles,
// materials, light and camera.
#pragma once

#include "peers/soup.h"

namespace rc::bench {

struct Surface {
  Vec3 colour{0.75f};
  float specular = 0, shininess = 1, reflection = 0;
  float transmittance = 0, refractionIndex = 1;
};

inline constexpr Vec3 kBackground{0.1f, 0.15f, 0.25f};
inline constexpr float kAmbient = 0.15f;  // of the light

struct Mesh {
  std::vector<Vec3> vertices;  // three a triangle
  std::vector<Vec3> normals;   // one a vertex; none: flat
  Surface surface;
};

struct FrameScene {
  std::string name;
  std::string peer;          // what the Whitted renderer on Embree calls it; empty: it does not have it
  std::vector<Mesh> meshes;  // static
  std::vector<Mesh> moving;  // drawn anew for each frame
  Camera camera;
  std::vector<Vec3> lights;
  int bounces = 14;
};

// Those that the Whitted renderer on Embree has too: "cornell", "bunny", "sponza", "sponzamirror", "dyn70k", "dyn10k".
// Those of glass.h. Ours alone: "swarm", 100 balls of 100 triangles that move one by one in Sponza; with a number
// behind it, "hills" of so many triangles, "lights" over a bunny, "bounces" in a room of mirrors. Nothing where a file
// is missing.
std::optional<FrameScene> loadFrameScene(const std::string &name, const std::string &folder);

// The measured box of Cornell University, one of its blocks a mirror.
std::vector<Mesh> cornellMeshes(const Soup &soup);

// The moving mesh at a frame: turns about an axis and breathes.
void deform(const Mesh &still, int frame, std::vector<Vec3> &vertices);

// The files that the peer reads: a count, then nine floats a triangle.
void writeSoups(const std::string &folder, const std::string &scenes);

}  // namespace rc::bench
