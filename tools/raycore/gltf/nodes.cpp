// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "gltf/accessor.h"
#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

Quat quatFrom(const std::vector<float> &v) {
  const Quat q(v[3], v[0], v[1], v[2]);
  const float length = glm::length(q);
  return length > 0 ? q / length : Quat(1, 0, 0, 0);
}

// EXT_mesh_gpu_instancing: a matrix for each instance.
std::vector<Mat4> instancesOf(Document &document, const Value &attributes) {
  const auto read = [&](const char *key, std::initializer_list<size_t> widths) {
    return attributes[key] ? asVec4(readNumbers(document, attributes[key], widths)) : std::vector<Vec4>{};
  };
  const std::vector<Vec4> translations = read("TRANSLATION", {3}), rotations = read("ROTATION", {4}),
                          scales = read("SCALE", {3});
  const size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  std::vector<Mat4> result;
  for (size_t i = 0; i < count; ++i) {
    Mat4 matrix(1);
    if (i < translations.size()) matrix = glm::translate(matrix, Vec3(translations[i]));
    if (i < rotations.size()) {
      const Vec4 r = rotations[i];
      matrix *= glm::mat4_cast(quatFrom({r.x, r.y, r.z, r.w}));
    }
    if (i < scales.size()) matrix = glm::scale(matrix, Vec3(scales[i]));
    result.push_back(matrix);
  }
  return result;
}

void readPlace(const Value &about, Node &node) {
  if (about["matrix"]) {
    const std::vector<float> m = about["matrix"].numbers(16);
    std::memcpy(static_cast<void *>(&node.matrix), m.data(), sizeof node.matrix);
    node.hasMatrix = true;
  }
  node.translation = about["translation"].vec3(Vec3(0));
  node.scale = about["scale"].vec3(Vec3(1));
  if (about["rotation"]) node.rotation = quatFrom(about["rotation"].numbers(4));
}

Node nodeFrom(Document &document, const Value &about) {
  Node node;
  node.name = about["name"].text();
  node.mesh = about["mesh"].index(document.scene.meshes.size());
  node.camera = about["camera"].index(document.scene.cameras.size());
  node.skin = about["skin"].index(document.countOf("skins"));
  node.weights = about["weights"].numbers();
  node.children = about["children"].indices(document.countOf("nodes"));
  const Value extensions = about["extensions"];
  node.light = extensions["KHR_lights_punctual"]["light"].index(document.scene.lights.size());
  node.instances = instancesOf(document, extensions["EXT_mesh_gpu_instancing"]["attributes"]);
  readPlace(about, node);
  return node;
}

void linkParents(const Value &about, std::vector<Node> &nodes) {
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (size_t k = 0; k < nodes[i].children.size(); ++k) {
      Node &child = nodes[size_t(nodes[i].children[k])];
      if (child.parent >= 0) about[i]["children"][k].complain("node {} has two parents", nodes[i].children[k]);
      child.parent = static_cast<int>(i);
    }
  }
}

// Parents first, without recursion: chains may be long. What has one parent each and was reached twice is a cycle.
std::vector<int> orderFrom(const Value &roots, const std::vector<int> &rootNodes, const std::vector<Node> &nodes) {
  std::vector<int> order, waiting(rootNodes.rbegin(), rootNodes.rend());
  std::vector<bool> seen(nodes.size());
  while (!waiting.empty()) {
    const int index = waiting.back();
    waiting.pop_back();
    if (seen[size_t(index)]) roots.complain("node {} is reached twice", index);
    seen[size_t(index)] = true;
    order.push_back(index);
    const std::vector<int> &children = nodes[size_t(index)].children;
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
  return order;
}

// No scene: every node without a parent.
std::vector<int> rootsOf(const std::vector<Node> &nodes) {
  std::vector<int> roots;
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

}  // namespace

void readNodes(Document &document) {
  const Value about = document["nodes"], scenes = document["scenes"];
  std::vector<Node> &nodes = document.scene.nodes;
  for (size_t i = 0; i < about.size(); ++i) nodes.push_back(nodeFrom(document, about[i]));
  linkParents(about, nodes);
  const int chosen = document["scene"].index(scenes.size());
  if (scenes.size() > 1)
    document.scene.note(fmt::format("{} scenes: scene {} is drawn", scenes.size(), std::max(chosen, 0)));
  const Value list = scenes.size() > 0 ? scenes[size_t(std::max(chosen, 0))]["nodes"] : about;
  std::vector<int> roots = scenes.size() > 0 ? list.indices(nodes.size()) : rootsOf(nodes);
  for (const int root : roots) {
    if (nodes[size_t(root)].parent < 0) continue;
    document.scene.note(fmt::format("{}: node {} is a root and a child", list.place(), root));
    nodes[size_t(root)].parent = -1;
  }
  document.scene.order = orderFrom(list, roots, nodes);
}

}  // namespace rc::tool::gltf
