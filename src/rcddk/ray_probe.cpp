// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/ray_probe.h"

#include "rchal/units/coverage.h"
#include "rchal/units/hit_point.h"
#include "rchal/units/ray_generation.h"
#include "rchal/units/texture.h"
#include "rchal/units/traversal.h"

namespace rc::ddk {
namespace {

// A search that counts.
struct CountingSearch : hal::NearestSearch {
  RayAnswer &answer;

  void inner(const hal::BvhNode8 &node) {
    for (uint32_t i = 0; i < hal::BvhNode8::kWidth && node.child[i] != 0; ++i) ++answer.boxes;
  }
  void inner(const hal::KdNode8 &) { ++answer.boxes; }

  bool operator()(std::span<const uint32_t> indices) {
    answer.triangles += static_cast<uint32_t>(indices.size());
    return NearestSearch::operator()(indices);
  }
};

hal::Hit nextCounted(const hal::SceneView &scene, const hal::Ray &ray, const hal::HitOrder &after, RayAnswer &answer) {
  const hal::TraversalRay traversal(ray, after);
  const hal::ShearedRay sheared(ray);
  hal::Hit best;
  uint32_t base = 0;
  for (const hal::GeometryView &geometry : scene.geometry) {
    hal::walk(geometry, traversal, best.t, CountingSearch{{geometry.triangles, sheared, base, after, best}, answer});
    base += static_cast<uint32_t>(geometry.triangles.size());
  }
  return best;
}

// Whether the surface is there for the ray, at least in part.
bool isThere(const hal::SceneView &scene, const hal::Ray &ray, const hal::Hit &hit) {
  const auto [geometry, index] = hal::placeOf(scene, hit.primitive);
  const hal::HotTriangle &triangle = geometry.triangles[index];
  const hal::MaterialRow &material = hal::materialOf(scene, geometry, triangle);
  const hal::SurfacePoint point = hal::surfacePoint(geometry, index, hit, ray.direction);
  float opacity = 1;
  if (material.texture != hal::kNoTexture) {
    const hal::TextureView &texture = scene.textures[size_t(material.texture)];
    const float alpha = hal::sampleTexture(texture, point.uv, material.textureWrap, 0).w;
    opacity = hal::opacityOf(material, texture, alpha);
  }
  return hal::coverage(triangle.flags, point.front, opacity) > 0;
}

int32_t materialNameOf(const hal::SceneView &scene, uint32_t primitive) {
  const auto [geometry, index] = hal::placeOf(scene, primitive);
  const uint32_t material = geometry.triangles[index].material;
  return material < hal::kNamedMaterials ? static_cast<int32_t>(material) : 0;
}

}  // namespace

RayAnswer probePixel(const hal::SceneView &scene, int column, int row) {
  RayAnswer answer;
  const hal::Ray ray = hal::primaryRay(scene.camera, column, row, {}).ray;
  hal::HitOrder after;
  for (;;) {
    const hal::Hit hit = nextCounted(scene, ray, after, answer);
    if (!hit.found()) return answer;
    after = {hit.t, hit.primitive};
    if (!isThere(scene, ray, hit)) continue;
    answer.distance = hit.t;
    answer.material = materialNameOf(scene, hit.primitive);
    return answer;
  }
}

}  // namespace rc::ddk
