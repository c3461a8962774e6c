// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ray_kinds.h: rays as they come: random ones, those of cameras and to lights, and those that structures and tests of
// triangles stumble over: along the axes, through vertices and along edges, in the planes of triangles.
#pragma once

#include <string>

#include "common/meshes.h"

namespace rc::test {

enum class RayKind { Random, Camera, Diagonal, ToLight, Parallel, Axis, Edge, Grazing, FarAxis, Slanted };
inline constexpr RayKind kAllRayKinds[] = {RayKind::Random,   RayKind::Camera, RayKind::Diagonal, RayKind::ToLight,
                                           RayKind::Parallel, RayKind::Axis,   RayKind::Edge,     RayKind::Grazing,
                                           RayKind::FarAxis,  RayKind::Slanted};
inline std::string nameOf(RayKind kind) {
  static constexpr const char *kNames[] = {"Random", "Camera", "Diagonal", "ToLight", "Parallel",
                                           "Axis",   "Edge",   "Grazing",  "FarAxis", "Slanted"};
  return kNames[size_t(kind)];
}

inline std::string nameOf(AccelKind kind) {
  static constexpr const char *kNames[] = {"KdTree", "Bvh", "Exhaustive"};
  return kNames[size_t(kind)];
}

// From one point through a window, in rows of 16 as tiles have them.
inline std::vector<hal::Ray> cameraRays(size_t count, const Vec3 &eye, const Vec3 &forward, const Vec3 &side) {
  const Vec3 up = glm::cross(side, forward);
  const size_t rows = (count + 15) / 16;
  std::vector<hal::Ray> rays;
  for (size_t i = 0; i < count; ++i) {
    const auto column = i % 16, row = i / 16;
    const float x = float(column) / 16 - 0.47f, y = float(row) / float(rows) - 0.5f;
    rays.push_back({eye, glm::normalize(forward + x * side + y * up)});
  }
  return rays;
}

// A point of a random triangle of the scene: inside, on an edge or a vertex.
class Targets {
 public:
  Targets(const hal::SceneView &scene, uint32_t seed) : mScene(scene), mRandom(seed) {}

  float unit() { return std::uniform_real_distribution<float>(0, 1)(mRandom); }
  const hal::HotTriangle &triangle() {
    const auto count = uint32_t(mScene.geometry[0].triangles.size() + mScene.geometry[1].triangles.size());
    const hal::PrimitivePlace place = hal::placeOf(mScene, uint32_t(mRandom() % count));
    return place.geometry.triangles[place.index];
  }
  Vec3 onEdge(const hal::HotTriangle &t) {
    const float share = mRandom() % 4 == 0 ? 0.0f : unit();
    return t.v0 + share * (t.v1 - t.v0);
  }
  Vec3 direction() {
    const float x = unit() - 0.5f, y = unit() - 0.5f, z = unit() - 0.5f;
    return normalizedOr({x, y, z}, {0, 0, 1});
  }

 private:
  const hal::SceneView &mScene;
  std::mt19937 mRandom;
};

inline hal::Ray rayAt(RayKind kind, Targets &targets) {
  const hal::HotTriangle &t = targets.triangle();
  const Vec3 edgePoint = targets.onEdge(t);
  switch (kind) {
    case RayKind::ToLight: {  // from a surface, or through one
      const Vec3 toLight = Vec3(0.4f, 2.5f, 0.3f) - edgePoint;
      return {edgePoint + (targets.unit() < 0.5f ? 1e-4f : -0.3f) * toLight, glm::normalize(toLight)};
    }
    case RayKind::Parallel:
      return {edgePoint + 1.5f * glm::normalize(Vec3(0.3f, 1, 0.2f)), -glm::normalize(Vec3(0.3f, 1, 0.2f))};
    case RayKind::Axis: {
      Vec3 axis(0);
      axis[int(3 * targets.unit()) % 3] = targets.unit() < 0.5f ? -1.0f : 1.0f;
      return {edgePoint - 2.0f * axis, axis};
    }
    // From far away, along an axis or all but along it: what is left of the direction still counts.
    case RayKind::FarAxis:
    case RayKind::Slanted: {
      const int axis = int(3 * targets.unit()) % 3;
      Vec3 d(0);
      d[axis] = targets.unit() < 0.5f ? -1.0f : 1.0f;
      if (kind == RayKind::Slanted) {
        for (int other : {(axis + 1) % 3, (axis + 2) % 3}) {
          d[other] = (targets.unit() - 0.5f) * std::pow(10.0f, -6 - 6 * targets.unit());
        }
      }
      return {edgePoint - d * std::pow(10.0f, 4 * targets.unit()), d};
    }
    case RayKind::Edge: {
      const Vec3 d = targets.direction();
      return {edgePoint - 2.0f * d, d};
    }
    default: {  // in the triangle's plane, or nearly
      const Vec3 along = normalizedOr(t.v2 - edgePoint, {1, 0, 0});
      const Vec3 d = glm::normalize(along + 1e-5f * targets.unit() * targets.direction());
      return {edgePoint - 2.0f * d, d};
    }
  }
}

inline std::vector<hal::Ray> raysOf(RayKind kind, size_t count, const hal::SceneView &scene) {
  if (kind == RayKind::Random) return randomRays(count, 7);
  if (kind == RayKind::Camera) return cameraRays(count, {0.5f, 2, 3}, glm::normalize(Vec3(0, -2, -3)), {1, 0, 0});
  // Where the largest component of the direction changes amid the tiles.
  if (kind == RayKind::Diagonal) {
    return cameraRays(count, {-1.5f, 1.5f, 0.4f}, glm::normalize(Vec3(1, -1, 0)), {0, 0, 1});
  }
  Targets targets(scene, 11);
  std::vector<hal::Ray> rays;
  while (rays.size() < count) rays.push_back(rayAt(kind, targets));
  return rays;
}

}  // namespace rc::test
