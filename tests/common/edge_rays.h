// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// edge_rays.h: rays that aim exactly at what triangles have in common, an edge or a vertex, from where the surface
// beside it lies on all sides of the ray: none of them may pass. Meshes need not be closed: edges of one triangle, and
// silhouettes as seen from the ray's origin, are left out.
#pragma once

#include <array>
#include <bit>
#include <optional>
#include <unordered_map>

#include "common/meshes.h"

namespace rc::test {

class EdgeRays {
 public:
  struct AimedRay {
    hal::Ray ray;
    float latest;  // where it has met the surface at last, a little behind the place that it aims at
  };

  EdgeRays(std::span<const hal::HotTriangle> triangles, uint32_t seed) : mTriangles(triangles), mRandom(seed) {
    for (uint32_t i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) mAround[keyOf(corner(i, k))].push_back(i);
      for (const Vec3 &v : {triangles[i].v0, triangles[i].v1, triangles[i].v2}) mBox.add(v);
    }
  }

  // Groups of 256 have a common origin every second time, as tiles and lights have.
  std::vector<AimedRay> some(size_t count) {
    std::vector<AimedRay> rays;
    Vec3 origin = anyOrigin();
    for (size_t tries = 0; rays.size() < count && tries < 1000 * count; ++tries) {
      if (rays.size() / 256 % 2 || tries % 1024 == 0) origin = anyOrigin();
      const auto triangle = uint32_t(mRandom() % mTriangles.size());
      const int first = int(mRandom() % 3);
      const auto aimed =
          mRandom() % 4 == 0 ? atVertex(origin, corner(triangle, first)) : atEdge(origin, triangle, first);
      if (aimed) rays.push_back(*aimed);
    }
    return rays;
  }

  // Whether a hit is at or before what the ray aimed at.
  static bool stopped(const AimedRay &aimed, const hal::Hit &hit) { return hit.found() && hit.t <= aimed.latest; }

 private:
  using Key = std::array<uint32_t, 3>;
  struct Hash {
    size_t operator()(const Key &key) const {
      return (key[0] * 0x9e3779b97f4a7c15u ^ key[1]) * 0x9e3779b97f4a7c15u ^ key[2];
    }
  };

  static Key keyOf(const Vec3 &v) {
    const Vec3 plain = v + Vec3(0);  // -0 is 0
    return {std::bit_cast<uint32_t>(plain.x), std::bit_cast<uint32_t>(plain.y), std::bit_cast<uint32_t>(plain.z)};
  }
  const Vec3 &corner(uint32_t triangle, int k) const {
    const hal::HotTriangle &t = mTriangles[triangle];
    return k % 3 == 0 ? t.v0 : k % 3 == 1 ? t.v1 : t.v2;
  }
  float unit() { return std::uniform_real_distribution<float>(0, 1)(mRandom); }

  Vec3 anyOrigin() {
    const Vec3 share{unit(), unit(), unit()};
    return mBox.centre() + (share - 0.5f) * 3.0f * maxComponent(mBox.size());
  }

  // On which side of the plane through an edge, along the ray, a point lies: -1, 1, or 0 where it is not sure.
  int sideOf(const Vec3 &a, const Vec3 &b, const Vec3 &direction, const Vec3 &point) const {
    const glm::dvec3 edge = glm::dvec3(b) - glm::dvec3(a), away = glm::dvec3(point) - glm::dvec3(a);
    const glm::dvec3 normal = glm::cross(edge, glm::dvec3(direction));
    const double height = glm::dot(normal, away),
                 sure = glm::length(edge) * std::max(1e-2 * glm::length(away), 16.0 * step());
    return height > sure ? 1 : height < -sure ? -1 : 0;
  }

  std::optional<AimedRay> aim(const Vec3 &origin, const Vec3 &at) const {
    const float distance = glm::length(at - origin);
    // What rounding of the direction moves the place by must be less than triangles are wide.
    if (!(distance > 0.05f * maxComponent(mBox.size()))) return std::nullopt;
    return AimedRay{{origin, (at - origin) / distance}, 1.001f * distance + 100 * step()};
  }

  // Of floats, where the mesh is.
  float step() const {
    return maxComponent(glm::max(glm::abs(mBox.lower), glm::abs(mBox.upper)) + mBox.size()) * 0x1p-23f;
  }

  bool isLarge(uint32_t triangle) const {
    const Vec3 &a = corner(triangle, 0), &b = corner(triangle, 1), &c = corner(triangle, 2);
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a);
    const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    return glm::length(glm::cross(ab, ac)) > 16.0 * step() * longest;
  }

  std::optional<AimedRay> atEdge(const Vec3 &origin, uint32_t triangle, int first) {
    const Vec3 &a = corner(triangle, first), &b = corner(triangle, first + 1), &mine = corner(triangle, first + 2);
    const auto aimed = aim(origin, a + (0.05f + 0.9f * unit()) * (b - a));
    if (!aimed || !isLarge(triangle)) return std::nullopt;
    const int side = sideOf(a, b, aimed->ray.direction, mine);
    if (side == 0) return std::nullopt;
    for (const uint32_t other : mAround.at(keyOf(a))) {
      for (int k = 0; k < 3 && other != triangle; ++k) {
        const bool shares = keyOf(corner(other, k)) == keyOf(b) && keyOf(corner(other, k + 1)) == keyOf(a);
        if (shares && isLarge(other) && sideOf(a, b, aimed->ray.direction, corner(other, k + 2)) == -side) return aimed;
      }
    }
    return std::nullopt;
  }

  // Where each edge at the vertex has a triangle on both sides, and all lie the same way round.
  std::optional<AimedRay> atVertex(const Vec3 &origin, const Vec3 &vertex) {
    const auto aimed = aim(origin, vertex);
    if (!aimed) return std::nullopt;
    std::unordered_map<Key, int, Hash> spokes;
    int turn = 0;
    for (const uint32_t triangle : mAround.at(keyOf(vertex))) {
      int k = 0;
      while (keyOf(corner(triangle, k)) != keyOf(vertex)) ++k;
      const Vec3 &next = corner(triangle, k + 1), &last = corner(triangle, k + 2);
      const int side = sideOf(vertex, next, aimed->ray.direction, last);
      if (side == 0 || (turn != 0 && side != turn) || !isLarge(triangle)) return std::nullopt;
      turn = side;
      ++spokes[keyOf(next)];
      --spokes[keyOf(last)];
    }
    for (const auto &[key, balance] : spokes) {
      if (balance != 0) return std::nullopt;
    }
    return aimed;
  }

  std::span<const hal::HotTriangle> mTriangles;
  std::mt19937 mRandom;
  std::unordered_map<Key, std::vector<uint32_t>, Hash> mAround;
  Bounds mBox;
};

}  // namespace rc::test
