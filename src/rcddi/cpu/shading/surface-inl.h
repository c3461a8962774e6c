// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// surface-inl.h: units/hit_point.h and units/ray_cone.h for lanes: from hits to points on surfaces.
// In: RayQueue, HitQueue, where the vector begins.  Out: RayLanes, SurfaceLanes.  Next: texture-inl.h, lighting-inl.h
#if defined(RAYCORE_SHADING_SURFACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_SURFACE_INL
#undef RAYCORE_SHADING_SURFACE_INL
#else
#define RAYCORE_SHADING_SURFACE_INL
#endif

#include "rcddi/cpu/shading/elementary-inl.h"
#include "rchal/units/shading.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// What all vectors of a batch need to know of the frame.
struct Shading {
  const hal::SceneView &scene;
  const hal::RayQueue &rays;
  const hal::HitQueue &hits;
  const hal::Outputs &out;
  bool last;   // of the generations: surfaces show their own colour only
  bool cones;  // somebody asks for the width of rays
};

// Rays of a queue, and what they hit.
struct RayLanes {
  size_t first;  // place in the queue
  M found;       // lanes that hit something; what the others hold means nothing
  V3 direction, weight;
  U pixel;
  F t, u, v;
  U primitive;              // through both sets
  F coneWidth, coneSpread;  // at the hit
};

// The floats of a triangle, and of its attributes, where each lane finds them. Lanes without a hit look at another
// one's triangle.
struct TrianglePlaces {
  const float *triangle[kMostLanes], *attributes[kMostLanes];
  bool one;  // all lanes have one triangle
};

// The attributes of triangles as rows of four floats, those that somebody asks for.
struct AttributeLanes {
  F floats[sizeof(hal::TriangleAttributes) / sizeof(float)];
};
constexpr size_t kNormalOffset = offsetof(hal::TriangleAttributes, normal) / sizeof(float);
constexpr size_t kUvOffset = offsetof(hal::TriangleAttributes, uv) / sizeof(float);
constexpr size_t kColorOffset = offsetof(hal::TriangleAttributes, color) / sizeof(float);

struct SurfaceLanes {
  bool one;  // all lanes have one triangle
  U material, flags;
  M dynamic;       // lanes with triangles of the second set
  V3 vertices[3];  // where the width of rays is known
  V3 position, flatNormal, normal, color;
  F safeOffset, doubleArea;
  F s, t;  // texture coordinates
  M front;
  AttributeLanes attributes;
};

HWY_INLINE M hasFlag(U flags, uint32_t flag) {
  return hn::RebindMask(FTag(), hn::Ne(hn::And(flags, hn::Set(UTag(), flag)), hn::Zero(UTag())));
}

HWY_INLINE V3 offset(const SurfaceLanes &surface, const V3 &direction, F distance) {
  const M inwards = hn::Lt(dot(direction, surface.flatNormal), zero());
  return select(inwards, hn::Neg(distance), distance) * surface.flatNormal;
}
HWY_INLINE V3 start(const SurfaceLanes &surface, const V3 &direction) {
  return surface.position + offset(surface, direction, surface.safeOffset);
}

// Lanes behind the end of the queue count as rays without a hit.
RC_STEP RayLanes loadRays(const Shading &shading, size_t first, M valid) {
  RayLanes out;
  const hal::RayQueue &rays = shading.rays;
  out.first = first;
  out.t = load(shading.hits.t, first);
  out.u = load(shading.hits.u, first);
  out.v = load(shading.hits.v, first);
  out.primitive = load(shading.hits.primitive, first);
  const auto hit = hn::Ne(out.primitive, hn::Set(UTag(), hal::kNoPrimitive));
  out.found = hn::And(valid, hn::RebindMask(FTag(), hit));
  out.weight = load(rays.weight, first);
  out.pixel = load(rays.pixel, first);
  out.direction = load(rays.direction, first);
  out.coneWidth = out.coneSpread = zero();
  if (!shading.cones) return out;
  const F spread = load(rays.coneSpread, first);
  const F width = hn::Add(load(rays.coneWidth, first), hn::Mul(spread, out.t));
  out.coneWidth = hn::Abs(width);  // behind a focus the cone widens again
  out.coneSpread = select(hn::Lt(width, zero()), hn::Neg(spread), spread);
  return out;
}

// found: not empty.
RC_STEP void findTriangles(const Shading &shading, const RayLanes &rays, TrianglePlaces &out) {
  const UTag du;
  const auto place = [&](size_t lane, uint32_t primitive) HWY_ATTR {
    const auto [geometry, index] = hal::placeOf(shading.scene, primitive);
    out.triangle[lane] = reinterpret_cast<const float *>(geometry.triangles.data() + index);
    out.attributes[lane] = reinterpret_cast<const float *>(geometry.attributes.data() + index);
  };
  const size_t someLane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bitsOf(FTag(), rays.found));
  const uint32_t some = shading.hits.primitive[rays.first + someLane];
  const auto found = hn::RebindMask(du, rays.found);
  out.one = hn::AllFalse(du, hn::And(found, hn::Ne(rays.primitive, hn::Set(du, some))));
  if (out.one) return place(0, some);
  alignas(64) uint32_t primitives[kMostLanes];
  hn::Store(hn::IfThenElse(found, rays.primitive, hn::Set(du, some)), du, primitives);
  for (size_t i = 0; i < lanes(); ++i) place(i, primitives[i]);
}

RC_STEP void loadRow(const float *const (&places)[kMostLanes], bool one, size_t offset, F *out) {
  if (!one) return loadRow(places, offset, out);
  for (size_t k = 0; k < 4; ++k) out[k] = all(places[0][offset + k]);
}

// The floats kBegin ... kEnd - 1 of each lane's place, and those that share rows of four with them. Not a loop:
// compilers would leave it as it is, and all floats in memory.
template <size_t kBegin, size_t kEnd>
RC_STEP void loadFloats(const float *const (&places)[kMostLanes], bool one, F *out) {
  loadRow(places, one, kBegin / 4 * 4, out + kBegin / 4 * 4);
  if constexpr (kBegin / 4 * 4 + 4 < kEnd) loadFloats<kBegin / 4 * 4 + 4, kEnd>(places, one, out);
}

RC_STEP void loadTriangles(const Shading &shading, const RayLanes &rays, const TrianglePlaces &places,
                           V3 (&vertices)[3], SurfaceLanes &out) {
  F row[sizeof(hal::HotTriangle) / sizeof(float)];
  loadFloats<0, std::size(row)>(places.triangle, places.one, row);
  for (size_t k = 0; k < 3; ++k) {
    vertices[k] = {row[3 * k], row[3 * k + 1], row[3 * k + 2]};
    if (shading.cones) out.vertices[k] = vertices[k];
  }
  const UTag du;
  out.material = hn::BitCast(du, row[9]);
  out.flags = hn::BitCast(du, row[10]);
  out.safeOffset = row[11];
  out.flatNormal = {row[12], row[13], row[14]};
  out.doubleArea = row[15];
  out.one = places.one;
  const U firstDynamic = hn::Set(du, static_cast<uint32_t>(shading.scene.geometry[0].triangles.size()));
  if (!out.one) out.dynamic = hn::Not(hn::RebindMask(FTag(), hn::Lt(rays.primitive, firstDynamic)));
  F *const floats = out.attributes.floats;
  if (!none(hn::And(rays.found, hasFlag(out.flags, hal::kHasNormals | hal::kTangentFrame)))) {
    loadFloats<kNormalOffset, kNormalOffset + 9>(places.attributes, places.one, floats);
  }
  if (!shading.scene.textures.empty()) loadFloats<kUvOffset, kUvOffset + 6>(places.attributes, places.one, floats);
  if (!none(hn::And(rays.found, hasFlag(out.flags, hal::kHasColors)))) {
    loadFloats<kColorOffset, kColorOffset + 9>(places.attributes, places.one, floats);
  }
}

// A vector that the corners of triangles have: its place in the attributes.
HWY_INLINE V3 corner(const AttributeLanes &attributes, size_t offset, size_t which) {
  const F *first = attributes.floats + offset + 3 * which;
  return {first[0], first[1], first[2]};
}
HWY_INLINE V3 interpolated(const AttributeLanes &attributes, size_t offset, F w0, F w1, F w2) {
  return w0 * corner(attributes, offset, 0) + w1 * corner(attributes, offset, 1) + w2 * corner(attributes, offset, 2);
}

// One texture coordinate of the corners: axis 0 is s, 1 is t.
struct CornerValues {
  F a, b, c;
};
HWY_INLINE CornerValues cornerCoordinates(const AttributeLanes &attributes, size_t axis) {
  const F *first = attributes.floats + kUvOffset + axis;
  return {first[0], first[2], first[4]};
}
HWY_INLINE F interpolated(const CornerValues &values, F w0, F w1, F w2) {
  return hn::Add(hn::Add(hn::Mul(w0, values.a), hn::Mul(w1, values.b)), hn::Mul(w2, values.c));
}

RC_STEP void surfaceOf(const Shading &shading, const RayLanes &rays, SurfaceLanes &out) {
#if HWY_TARGET == HWY_SCALAR  // one lane: GCC cannot see that nothing is read which was not set
  out = {};
#endif
  TrianglePlaces places;
  findTriangles(shading, rays, places);
  V3 vertices[3];
  loadTriangles(shading, rays, places, vertices, out);
  const auto &[v0, v1, v2] = vertices;
  const F w0 = hn::Sub(hn::Sub(all(1), rays.u), rays.v), w1 = rays.u, w2 = rays.v;
  out.position = w0 * v0 + w1 * v1 + w2 * v2;
  const V3 geometric = out.flatNormal;
  const M counterClockwise = hn::Lt(dot(geometric, rays.direction), zero());
  out.front = hn::Xor(counterClockwise, hasFlag(out.flags, hal::kClockwiseFront));
  out.flatNormal = select(counterClockwise, geometric, -geometric);

  out.normal = out.flatNormal;
  const M hasNormals = hn::And(rays.found, hasFlag(out.flags, hal::kHasNormals));
  if (!none(hasNormals)) {
    const V3 smooth = normalizedOr(interpolated(out.attributes, kNormalOffset, w0, w1, w2), out.flatNormal);
    const V3 towards = negateWhere(hn::Lt(dot(smooth, out.flatNormal), zero()), smooth);
    out.normal = select(hasNormals, towards, out.flatNormal);
  }
  const M hasColors = hn::And(rays.found, hasFlag(out.flags, hal::kHasColors));
  if (!none(hasColors)) out.color = interpolated(out.attributes, kColorOffset, w0, w1, w2);
  if (!shading.scene.textures.empty()) {
    out.s = interpolated(cornerCoordinates(out.attributes, 0), w0, w1, w2);
    out.t = interpolated(cornerCoordinates(out.attributes, 1), w0, w1, w2);
  }
}

RC_STEP F curvature(const SurfaceLanes &surface, M asked) {
  const M smooth = hn::And(asked, hasFlag(surface.flags, hal::kHasNormals));
  if (none(smooth)) return zero();
  F sum = zero();
  for (size_t i = 0; i < 3; ++i) {
    const size_t next = (i + 1) % 3;
    const V3 edge = surface.vertices[next] - surface.vertices[i];
    const V3 turn = corner(surface.attributes, kNormalOffset, next) - corner(surface.attributes, kNormalOffset, i);
    sum = hn::Add(sum, hn::Div(dot(turn, edge), dot(edge, edge)));
  }
  const M turned = hn::Lt(dot(corner(surface.attributes, kNormalOffset, 0), surface.flatNormal), zero());
  return onlyWhere(smooth, hn::Div(select(turned, hn::Neg(sum), sum), all(3)));
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
