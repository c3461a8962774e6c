// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scene.h: a model as plain data: what every loader makes and everything else reads.
// Colours are linear where a comment says so and display values elsewhere; texture coordinates have v = 0 at the
// picture's first row; indices of other objects are -1 where there is none.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/material.h"
#include "scene/math.h"

namespace rc::tool {

struct Image {
  std::string name;
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;  // the first row is the top one; empty: could not be read
};

enum class Wrap : int { Repeat, Clamp, Mirror };

struct Texture {
  int image = -1;
  Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
};

// Displacements of a primitive's vertices; an empty array displaces nothing.
struct MorphTarget {
  std::vector<Vec3> positions, normals;
};

using Joints = std::array<uint32_t, 4>;

// Triangles of one material. Arrays other than positions are empty or as long as positions.
struct Primitive {
  std::vector<Vec3> positions, normals;
  std::vector<Vec4> colors;
  std::array<std::vector<Vec2>, 2> uvs;
  std::vector<Joints> joints;
  std::vector<Vec4> weights;
  std::vector<uint32_t> indices;  // three a triangle, all within positions
  std::vector<MorphTarget> targets;
  int material = -1;

  size_t triangles() const { return indices.size() / 3; }
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> weights;  // of morph targets
};

struct Skin {
  std::string name;
  std::vector<int> joints;  // nodes
  std::vector<Mat4> inverseBind;
};

struct Node {
  std::string name;
  int parent = -1, mesh = -1, skin = -1, camera = -1, light = -1;
  std::vector<int> children;
  bool hasMatrix = false;  // then matrix counts, else translation, rotation and scale
  Mat4 matrix{1};
  Vec3 translation{0}, scale{1};
  Quat rotation{1, 0, 0, 0};
  std::vector<float> weights;   // instead of the mesh's, if there are any
  std::vector<Mat4> instances;  // the mesh is drawn once for each, if there are any
};

enum class Path : int { Translation, Rotation, Scale, Weights };
enum class Interpolation : int { Linear, Step, Cubic };

struct Channel {
  int node = -1;
  Path path = Path::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<float> times;   // seconds, ascending
  std::vector<float> values;  // width a key; Cubic: in-tangent, value, out-tangent
  int width = 3;
};

struct Animation {
  std::string name;
  std::vector<Channel> channels;

  float duration() const;
};

struct Camera {
  std::string name;
  bool orthographic = false;
  float yfov = 0.8f;         // radians
  float xmag = 1, ymag = 1;  // half sizes, orthographic
  float znear = 0.1f;
};

enum class LightKind : int { Directional, Point, Spot };

struct Light {
  std::string name;
  LightKind kind = LightKind::Point;
  Vec3 color{1};        // linear
  float intensity = 1;  // lux or candela
  float range = 0;      // 0: no end
  float innerCone = 0, outerCone = 0.785398f;
};

struct Scene {
  std::string format;
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Skin> skins;
  std::vector<Node> nodes;
  std::vector<int> order;  // nodes of the scene, parents before children
  std::vector<Animation> animations;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<std::string> notes;  // what was dropped or approximated, and why
  bool zUp = false;

  // Each text once.
  void note(const std::string &text);
};

}  // namespace rc::tool
