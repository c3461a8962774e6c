// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// footprint-inl.h: units/footprint.h for lanes: what of a texture each ray sees.
// In: RayLanes, SurfaceLanes, TextureView.  Out: TexelLanes.  Next: shade-inl.h
#if defined(RAYCORE_SHADING_FOOTPRINT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_FOOTPRINT_INL
#undef RAYCORE_SHADING_FOOTPRINT_INL
#else
#define RAYCORE_SHADING_FOOTPRINT_INL
#endif

#include "rcddi/cpu/shading/texture-inl.h"
#include "rchal/units/footprint.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// Differences of texture coordinates along two edges of the triangles.
struct CoordinateEdges {
  F duX, duY, dvX, dvY;

  explicit CoordinateEdges(const SurfaceLanes &surface) {
    const CornerValues s = cornerCoordinates(surface.attributes, 0), t = cornerCoordinates(surface.attributes, 1);
    duX = hn::Sub(s.b, s.a), duY = hn::Sub(t.b, t.a);
    dvX = hn::Sub(s.c, s.a), dvY = hn::Sub(t.c, t.a);
  }
};

// The level of detail of a texture where the rays' cones meet the surface.
RC_STEP F levelOfDetail(const RayLanes &rays, const SurfaceLanes &surface, const hal::TextureView &texture) {
  const CoordinateEdges edges(surface);
  const F area = hn::Abs(hn::Sub(hn::Mul(edges.duX, edges.dvY), hn::Mul(edges.dvX, edges.duY)));
  const F texelArea = hn::Mul(hn::Mul(area, all(float(texture.width))), all(float(texture.height)));
  const F cosine = hn::Max(hn::Abs(dot(surface.flatNormal, -rays.direction)), all(hal::kLeastCosine));
  const F texels = hn::Mul(texelArea, hn::Mul(rays.coneWidth, rays.coneWidth));
  return hn::Mul(all(0.5f), log2Of(hn::Div(texels, hn::Mul(surface.doubleArea, hn::Mul(cosine, cosine)))));
}

struct FootprintLanes {
  F lod, probes;
  F axisS, axisT;
};

RC_STEP FootprintLanes stretchedFootprint(const RayLanes &rays, const SurfaceLanes &surface,
                                          const hal::TextureView &texture) {
  const V3 e1 = surface.vertices[1] - surface.vertices[0], e2 = surface.vertices[2] - surface.vertices[0];
  const V3 &normal = surface.flatNormal;
  const CoordinateEdges edges(surface);
  const auto onTexture = [&](const V3 &way, F &s, F &t) HWY_ATTR {
    const F u = hn::Div(dot(cross(way, e2), normal), surface.doubleArea);
    const F v = hn::Div(dot(cross(e1, way), normal), surface.doubleArea);
    s = hn::Add(hn::Mul(u, edges.duX), hn::Mul(v, edges.dvX));
    t = hn::Add(hn::Mul(u, edges.duY), hn::Mul(v, edges.dvY));
  };
  const auto lengthOf = [&](F s, F t) HWY_ATTR {
    const F x = hn::Mul(s, all(float(texture.width))), y = hn::Mul(t, all(float(texture.height)));
    return hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
  };
  const F facing = dot(normal, rays.direction), edge = length(e1);
  const V3 anyWay{hn::Div(e1.x, edge), hn::Div(e1.y, edge), hn::Div(e1.z, edge)};
  const V3 along = normalizedOr(rays.direction - facing * normal, anyWay);
  F aS, aT, bS, bT;
  onTexture(hn::Div(rays.coneWidth, hn::Max(hn::Abs(facing), all(hal::kLeastCosine))) * along, aS, aT);
  onTexture(rays.coneWidth * cross(normal, along), bS, bT);
  const F lengthA = lengthOf(aS, aT), lengthB = lengthOf(bS, bT);
  const M aIsLonger = hn::Gt(lengthA, lengthB);
  const F longer = select(aIsLonger, lengthA, lengthB), shorter = select(aIsLonger, lengthB, lengthA);
  const F ratio = hn::Div(longer, hn::Max(shorter, all(1)));
  const F wanted = hn::Min(hn::Ceil(ratio), all(float(texture.anisotropy)));
  const F probes = select(hn::Gt(ratio, all(1)), wanted, all(1));
  return {log2Of(hn::Div(longer, probes)), probes, select(aIsLonger, aS, bS), select(aIsLonger, aT, bT)};
}

// As many samples as the lane with most of them needs; lanes take part as long as they need them.
RC_STEP TexelLanes sampleFootprint(const hal::TextureView &texture, const FootprintLanes &footprint, M valid, F s, F t,
                                   hal::Wraps wraps) {
  const F share = hn::Div(all(1), footprint.probes);
  TexelLanes sum{{zero(), zero(), zero()}, zero()};
  F i = zero();
  for (M open = valid; !none(open); open = hn::And(open, hn::Lt(i, footprint.probes))) {
    const F place = hn::Sub(hn::Mul(hn::Add(i, all(0.5f)), share), all(0.5f));
    const F atS = hn::Add(s, hn::Mul(place, footprint.axisS)), atT = hn::Add(t, hn::Mul(place, footprint.axisT));
    const TexelLanes texels = sampleTexture(texture, footprint.lod, open, atS, atT, wraps);
    sum = {sum.rgb + onlyWhere(open, texels.rgb), hn::Add(sum.alpha, onlyWhere(open, texels.alpha))};
    i = hn::Add(i, all(1));
  }
  return {share * sum.rgb, hn::Mul(share, sum.alpha)};
}

RC_STEP TexelLanes sample(const hal::SceneView &scene, const RayLanes &rays, const SurfaceLanes &surface, M asked,
                          int32_t name, hal::Wraps wraps) {
  const hal::TextureView &texture = scene.textures[size_t(name)];
  const bool levels = scene.mipmaps && texture.levelCount > 1;
  if (levels && texture.anisotropy > 1) {
    const FootprintLanes footprint = stretchedFootprint(rays, surface, texture);
    return sampleFootprint(texture, footprint, asked, surface.s, surface.t, wraps);
  }
  const F lod = levels ? levelOfDetail(rays, surface, texture) : zero();
  return sampleTexture(texture, lod, asked, surface.s, surface.t, wraps);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
