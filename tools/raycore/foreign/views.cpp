// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "foreign/convert.h"

namespace rc::tool::foreign {
namespace {

// Our cameras and lights look along -z of their node; Assimp's have a direction of their own.
Node looking(int parent, const Vec3 &position, const Vec3 &direction, const Vec3 &up) {
  Node node;
  node.parent = parent;
  node.hasMatrix = true;
  const bool directed = glm::length(direction) > 0 && glm::length(glm::cross(direction, up)) > 0;
  node.matrix =
      directed ? glm::inverse(glm::lookAt(position, position + direction, up)) : glm::translate(Mat4(1), position);
  return node;
}

int nodeNamed(const aiString &name, const NodeNames &names) {
  const auto found = names.find(name.C_Str());
  return found == names.end() ? 0 : found->second;
}

void convertCamera(const aiCamera &from, const NodeNames &names, Scene &to) {
  Camera camera;
  camera.name = from.mName.C_Str();
  const float aspect = from.mAspect > 0 ? from.mAspect : 1.0f;
  const float half = from.mHorizontalFOV > 0 && from.mHorizontalFOV < 3 ? 0.5f * from.mHorizontalFOV : 0.4f;
  camera.yfov = 2 * std::atan(std::tan(half) / aspect);
  Node node = looking(nodeNamed(from.mName, names), asVec3(from.mPosition), asVec3(from.mLookAt), asVec3(from.mUp));
  node.camera = static_cast<int>(to.cameras.size());
  to.cameras.push_back(camera);
  append(std::move(node), to);
}

void convertLight(const aiLight &from, const NodeNames &names, Scene &to) {
  if (from.mType == aiLightSource_AMBIENT) return to.note("ambient lights of the file: not used");
  Light light;
  light.name = from.mName.C_Str();
  light.kind = from.mType == aiLightSource_DIRECTIONAL ? LightKind::Directional
               : from.mType == aiLightSource_SPOT      ? LightKind::Spot
                                                       : LightKind::Point;
  const Vec3 colour = asVec3(from.mColorDiffuse);
  light.intensity = std::max(maxOf(colour), 1e-6f);
  light.color = colour / light.intensity;
  light.innerCone = 0.5f * from.mAngleInnerCone;
  light.outerCone = 0.5f * from.mAngleOuterCone;
  const Vec3 direction = asVec3(from.mDirection);
  const bool steep = std::abs(direction.y) > 0.9f * glm::length(direction);
  const Vec3 up = steep ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  Node node = looking(nodeNamed(from.mName, names), asVec3(from.mPosition), direction, up);
  node.light = static_cast<int>(to.lights.size());
  to.lights.push_back(light);
  append(std::move(node), to);
}

}  // namespace

void convertViews(const aiScene &from, const NodeNames &names, Scene &to) {
  for (unsigned i = 0; i < from.mNumCameras; ++i) convertCamera(*from.mCameras[i], names, to);
  for (unsigned i = 0; i < from.mNumLights; ++i) convertLight(*from.mLights[i], names, to);
}

}  // namespace rc::tool::foreign
