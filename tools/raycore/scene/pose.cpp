// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "scene/pose.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scene/keyframes.h"

namespace rc::tool {
namespace {

struct Local {
  bool animated = false;
  Vec3 translation, scale;
  Quat rotation;
};

Mat4 matrixOf(const Node &node, const Local &local) {
  if (node.hasMatrix && !local.animated) return node.matrix;
  return glm::translate(Mat4(1), local.translation) * glm::mat4_cast(local.rotation) * glm::scale(Mat4(1), local.scale);
}

void apply(const Channel &channel, const std::vector<float> &v, Local &local, std::vector<float> &weights) {
  if (v.empty()) return;
  if (channel.path == Path::Weights) {
    weights = v;
    return;
  }
  local.animated = true;
  if (channel.path == Path::Translation) local.translation = {v[0], v[1], v[2]};
  if (channel.path == Path::Scale) local.scale = {v[0], v[1], v[2]};
  if (channel.path == Path::Rotation) local.rotation = Quat(v[3], v[0], v[1], v[2]);
}

const std::vector<float> &restWeights(const Scene &scene, const Node &node) {
  static const std::vector<float> none;
  if (!node.weights.empty()) return node.weights;
  return node.mesh >= 0 ? scene.meshes[size_t(node.mesh)].weights : none;
}

}  // namespace

Pose poseAt(const Scene &scene, int animation, float seconds) {
  std::vector<Local> locals;
  Pose pose;
  for (const Node &node : scene.nodes) {
    locals.push_back({false, node.translation, node.scale, node.rotation});
    pose.weights.push_back(restWeights(scene, node));
  }
  if (animation >= 0) {
    for (const Channel &channel : scene.animations[size_t(animation)].channels) {
      const size_t node = size_t(channel.node);
      apply(channel, sampleChannel(channel, seconds), locals[node], pose.weights[node]);
    }
  }
  pose.world.assign(scene.nodes.size(), Mat4(1));
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    const Mat4 local = matrixOf(node, locals[size_t(index)]);
    pose.world[size_t(index)] = node.parent >= 0 ? pose.world[size_t(node.parent)] * local : local;
  }
  return pose;
}

std::vector<bool> movingNodes(const Scene &scene, int animation) {
  std::vector<bool> moved(scene.nodes.size()), result(scene.nodes.size());
  if (animation < 0) return moved;
  for (const Channel &channel : scene.animations[size_t(animation)].channels) {
    (channel.path == Path::Weights ? result : moved)[size_t(channel.node)] = true;
  }
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    if (node.parent >= 0 && moved[size_t(node.parent)]) moved[size_t(index)] = true;
  }
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    if (moved[size_t(index)]) result[size_t(index)] = true;
    if (node.skin < 0) continue;
    for (const int joint : scene.skins[size_t(node.skin)].joints) {
      if (moved[size_t(joint)]) result[size_t(index)] = true;
    }
  }
  return result;
}

std::vector<Vec3> morphed(const std::vector<Vec3> &base, const Primitive &primitive, const std::vector<float> &weights,
                          std::vector<Vec3> MorphTarget::*array) {
  std::vector<Vec3> result = base;
  for (size_t t = 0; t < primitive.targets.size() && t < weights.size(); ++t) {
    const std::vector<Vec3> &offsets = primitive.targets[t].*array;
    if (weights[t] == 0 || offsets.size() != base.size()) continue;
    for (size_t i = 0; i < base.size(); ++i) result[i] += weights[t] * offsets[i];
  }
  return result;
}

std::vector<Mat4> palette(const Scene &scene, const Pose &pose, int skin) {
  const Skin &bones = scene.skins[size_t(skin)];
  std::vector<Mat4> matrices;
  for (size_t i = 0; i < bones.joints.size(); ++i) {
    matrices.push_back(pose.world[size_t(bones.joints[i])] * bones.inverseBind[i]);
  }
  return matrices;
}

std::vector<Vec3> posedPositions(const Scene &scene, const Pose &pose, int node, const Primitive &primitive) {
  std::vector<Vec3> points =
      morphed(primitive.positions, primitive, pose.weights[size_t(node)], &MorphTarget::positions);
  const Node &owner = scene.nodes[size_t(node)];
  const bool skinned = owner.skin >= 0 && !primitive.joints.empty();
  const std::vector<Mat4> bones = skinned ? palette(scene, pose, owner.skin) : std::vector<Mat4>{};
  for (size_t i = 0; i < points.size(); ++i) {
    if (!skinned) {
      points[i] = Vec3(pose.world[size_t(node)] * Vec4(points[i], 1));
      continue;
    }
    Vec3 sum{0};
    for (int k = 0; k < 4; ++k) {
      sum += primitive.weights[i][k] * Vec3(bones[primitive.joints[i][size_t(k)]] * Vec4(points[i], 1));
    }
    points[i] = sum;
  }
  return points;
}

Bounds boundsOf(const Scene &scene, const Pose &pose) {
  Bounds bounds;
  const auto add = [&](const Vec3 &p) {
    if (glm::all(glm::lessThan(glm::abs(p), Vec3(1e30f)))) bounds.add(p);
  };
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    if (node.mesh < 0) continue;
    for (const Primitive &primitive : scene.meshes[size_t(node.mesh)].primitives) {
      const std::vector<Vec3> points = posedPositions(scene, pose, index, primitive);
      const Mat4 world = pose.world[size_t(index)], object = glm::inverse(world);
      if (node.instances.empty()) {
        for (const uint32_t i : primitive.indices) add(points[i]);
      }
      for (const Mat4 &instance : node.instances) {
        const Mat4 again = world * instance * object;
        for (const uint32_t i : primitive.indices) add(Vec3(again * Vec4(points[i], 1)));
      }
    }
  }
  return bounds;
}

}  // namespace rc::tool
