// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Skins and animations. [glTF 2.0, 3.7.3, 3.11]
#include <algorithm>
#include <array>
#include <cmath>

#include "gltf/accessor.h"
#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

Skin skinFrom(Document &document, const Value &about) {
  Skin skin{about["name"].text(), about.at("joints").indices(document.scene.nodes.size()), {}};
  const Value matrices = about["inverseBindMatrices"];
  if (matrices) skin.inverseBind = asMat4(readNumbers(document, matrices, {16}));
  if (matrices && skin.inverseBind.size() < skin.joints.size()) {
    matrices.complain("{} matrices for {} joints", skin.inverseBind.size(), skin.joints.size());
  }
  skin.inverseBind.resize(skin.joints.size(), Mat4(1));
  return skin;
}

// Every joint a vertex names must be one of the skin's.
void checkJoints(const Scene &scene) {
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node &node = scene.nodes[i];
    if (node.skin < 0 || node.mesh < 0) continue;
    const size_t joints = scene.skins[size_t(node.skin)].joints.size();
    for (const Primitive &primitive : scene.meshes[size_t(node.mesh)].primitives) {
      for (const Joints &named : primitive.joints) {
        const uint32_t largest = *std::max_element(named.begin(), named.end());
        if (largest >= joints) reject("nodes[{}].mesh: a vertex follows joint {} of {}", i, largest, joints);
      }
    }
  }
}

struct PathName {
  const char *name;
  Path path;
  int width;
};

constexpr std::array kPaths{PathName{"translation", Path::Translation, 3}, PathName{"rotation", Path::Rotation, 4},
                            PathName{"scale", Path::Scale, 3}, PathName{"weights", Path::Weights, 0}};

const PathName &pathOf(const Value &about) {
  const std::string name = about.text();
  for (const PathName &known : kPaths) {
    if (name == known.name) return known;
  }
  about.complain("\"{}\" is nothing that moves", name);
}

Interpolation interpolationOf(const Value &about) {
  const std::string name = about.text("LINEAR");
  if (name == "LINEAR") return Interpolation::Linear;
  if (name == "STEP") return Interpolation::Step;
  if (name == "CUBICSPLINE") return Interpolation::Cubic;
  about.complain("\"{}\" is no interpolation", name);
}

std::vector<float> readTimes(Document &document, const Value &accessor) {
  std::vector<float> times = readNumbers(document, accessor, {1}).values;
  const bool finite = std::all_of(times.begin(), times.end(), [](float t) { return std::isfinite(t); });
  if (!finite || !std::is_sorted(times.begin(), times.end())) accessor.complain("its times do not ascend");
  return times;
}

int morphTargets(const Scene &scene, const Node &node) {
  if (node.mesh < 0) return 0;
  const Mesh &mesh = scene.meshes[size_t(node.mesh)];
  return mesh.primitives.empty() ? 0 : static_cast<int>(mesh.primitives[0].targets.size());
}

void readChannel(Document &document, const Value &about, const Value &samplers, Animation &animation) {
  const Scene &scene = document.scene;
  const Value target = about.at("target");
  Channel channel;
  channel.node = target["node"].index(scene.nodes.size());
  if (channel.node < 0) return document.scene.note(target.place() + ": moves no node; not played");
  const PathName &path = pathOf(target.at("path"));
  channel.path = path.path;
  channel.width = path.path == Path::Weights ? morphTargets(scene, scene.nodes[size_t(channel.node)]) : path.width;
  if (channel.width == 0) return document.scene.note(target.place() + ": its mesh has no morph targets; not played");
  const Value sampler = samplers[size_t(about.at("sampler").index(samplers.size()))];
  channel.interpolation = interpolationOf(sampler["interpolation"]);
  channel.times = readTimes(document, sampler.at("input"));
  channel.values = readNumbers(document, sampler.at("output"), {1, 3, 4}).values;
  const size_t parts = channel.interpolation == Interpolation::Cubic ? 3 : 1;
  const size_t wanted = channel.times.size() * parts * size_t(channel.width);
  if (channel.values.size() < wanted) sampler["output"].complain("{} numbers, not {}", channel.values.size(), wanted);
  animation.channels.push_back(std::move(channel));
}

}  // namespace

void readSkins(Document &document) {
  const Value skins = document["skins"];
  for (size_t i = 0; i < skins.size(); ++i) document.scene.skins.push_back(skinFrom(document, skins[i]));
  checkJoints(document.scene);
}

void readAnimations(Document &document) {
  const Value animations = document["animations"];
  for (size_t i = 0; i < animations.size(); ++i) {
    Animation animation{animations[i]["name"].text(), {}};
    const Value channels = animations[i].at("channels"), samplers = animations[i].at("samplers");
    for (size_t k = 0; k < channels.size(); ++k) readChannel(document, channels[k], samplers, animation);
    document.scene.animations.push_back(std::move(animation));
  }
}

}  // namespace rc::tool::gltf
