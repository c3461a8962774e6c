// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pose.h: where everything is at one moment of an animation.
// In: Scene, an animation, seconds.  Out: world matrices and morph weights of the nodes.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace rc::tool {

struct Pose {
  std::vector<Mat4> world;                  // by node; identity for nodes outside the scene
  std::vector<std::vector<float>> weights;  // by node
};

// animation -1: as the file has it.
Pose poseAt(const Scene &scene, int animation, float seconds);

// Nodes whose world matrix, skin or weights the animation changes.
std::vector<bool> movingNodes(const Scene &scene, int animation);

// World-space positions of a primitive of a node, morphed and skinned; without the node's instances.
std::vector<Vec3> posedPositions(const Scene &scene, const Pose &pose, int node, const Primitive &primitive);

// Morphed arrays, object space.
std::vector<Vec3> morphed(const std::vector<Vec3> &base, const Primitive &primitive, const std::vector<float> &weights,
                          std::vector<Vec3> MorphTarget::*array);

// The matrices vertices of the skin are multiplied with.
std::vector<Mat4> palette(const Scene &scene, const Pose &pose, int skin);

// Bounds of all triangles of the scene; points that are not finite are left out.
Bounds boundsOf(const Scene &scene, const Pose &pose);

}  // namespace rc::tool
