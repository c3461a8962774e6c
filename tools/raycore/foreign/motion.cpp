// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Skins and animations of Assimp's scene.
#include <algorithm>

#include "foreign/convert.h"

namespace rc::tool::foreign {
namespace {

// The four strongest bones of each vertex.
void addWeight(Primitive &primitive, unsigned vertex, uint32_t bone, float weight) {
  Vec4 &weights = primitive.weights[vertex];
  int weakest = 0;
  for (int k = 1; k < 4; ++k) {
    if (weights[k] < weights[weakest]) weakest = k;
  }
  if (weight <= weights[weakest]) return;
  weights[weakest] = weight;
  primitive.joints[vertex][size_t(weakest)] = bone;
}

Skin skinFrom(const aiMesh &from, const NodeNames &names, Primitive &primitive) {
  Skin skin{from.mName.C_Str(), {}, {}};
  primitive.weights.assign(primitive.positions.size(), Vec4(0));
  primitive.joints.assign(primitive.positions.size(), Joints{});
  for (unsigned b = 0; b < from.mNumBones; ++b) {
    const aiBone &bone = *from.mBones[b];
    const auto node = names.find(bone.mName.C_Str());
    if (node == names.end()) continue;
    const uint32_t index = static_cast<uint32_t>(skin.joints.size());
    skin.joints.push_back(node->second);
    skin.inverseBind.push_back(asMat4(bone.mOffsetMatrix));
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const aiVertexWeight &weight = bone.mWeights[w];
      if (weight.mVertexId < primitive.positions.size()) addWeight(primitive, weight.mVertexId, index, weight.mWeight);
    }
  }
  for (Vec4 &w : primitive.weights) {
    const float sum = w.x + w.y + w.z + w.w;
    if (sum > 0) w /= sum;
  }
  return skin;
}

template <class Keys, class Values>
void addChannel(int node, Path path, const Keys *keys, unsigned count, double ticks, Values values, Animation &to) {
  if (count == 0) return;
  Channel channel;
  channel.node = node;
  channel.path = path;
  channel.width = path == Path::Rotation ? 4 : 3;
  for (unsigned i = 0; i < count; ++i) {
    channel.times.push_back(static_cast<float>(keys[i].mTime / ticks));
    values(keys[i].mValue, channel.values);
  }
  if (std::is_sorted(channel.times.begin(), channel.times.end())) to.channels.push_back(std::move(channel));
}

void addChannels(const aiNodeAnim &from, int node, double ticks, Animation &to) {
  const auto vector = [](const aiVector3D &v, std::vector<float> &out) { out.insert(out.end(), {v.x, v.y, v.z}); };
  const auto turn = [](const aiQuaternion &q, std::vector<float> &out) { out.insert(out.end(), {q.x, q.y, q.z, q.w}); };
  addChannel(node, Path::Translation, from.mPositionKeys, from.mNumPositionKeys, ticks, vector, to);
  addChannel(node, Path::Rotation, from.mRotationKeys, from.mNumRotationKeys, ticks, turn, to);
  addChannel(node, Path::Scale, from.mScalingKeys, from.mNumScalingKeys, ticks, vector, to);
}

}  // namespace

void convertSkins(const aiScene &from, const NodeNames &names, Scene &to) {
  for (unsigned i = 0; i < from.mNumMeshes; ++i) {
    if (from.mMeshes[i]->mNumBones == 0) continue;
    to.skins.push_back(skinFrom(*from.mMeshes[i], names, to.meshes[i].primitives[0]));
    for (Node &node : to.nodes) {
      if (node.mesh == int(i)) node.skin = static_cast<int>(to.skins.size()) - 1;
    }
  }
}

void convertAnimations(const aiScene &from, const NodeNames &names, Scene &to) {
  for (unsigned i = 0; i < from.mNumAnimations; ++i) {
    const aiAnimation &about = *from.mAnimations[i];
    const double ticks = about.mTicksPerSecond > 0 ? about.mTicksPerSecond : 25;
    Animation animation{about.mName.C_Str(), {}};
    for (unsigned c = 0; c < about.mNumChannels; ++c) {
      const auto node = names.find(about.mChannels[c]->mNodeName.C_Str());
      if (node != names.end()) addChannels(*about.mChannels[c], node->second, ticks, animation);
    }
    if (about.mNumMorphMeshChannels > 0) to.note("animated morph targets are played in glTF files only");
    to.animations.push_back(std::move(animation));
  }
}

}  // namespace rc::tool::foreign
