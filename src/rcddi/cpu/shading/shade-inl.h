// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shade-inl.h: units/shading.h for lanes: the hits of a batch, a vector at a time, in it one kind after the other, so
// that everything which a material decides is decided once.
// In: SceneView, RayQueue, HitQueue.  Out: sums of pixels, ShadowQueues by light, RayQueues.  Next: rchal/tile_tracer.h
#if defined(RAYCORE_SHADING_SHADE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_SHADE_INL
#undef RAYCORE_SHADING_SHADE_INL
#else
#define RAYCORE_SHADING_SHADE_INL
#endif

#include <hwy/cache_control.h>

#include "rcddi/cpu/shading/coverage-inl.h"
#include "rcddi/cpu/shading/fog-inl.h"
#include "rcddi/cpu/shading/footprint-inl.h"
#include "rcddi/cpu/shading/lighting-inl.h"
#include "rcddi/cpu/shading/secondary-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// The lanes of a vector whose hits need the same: one material, the same flags.
struct Kind {
  M lanes;
  const hal::MaterialRow *material;
  uint32_t flags;
  int secondary;  // kinds of rays that leave its hits, beside those that go straight on

  bool hasTexture() const { return material->texture != hal::kNoTexture; }
  bool hasNormalMap() const { return flags & hal::kTangentFrame && material->normalMap != hal::kNoTexture; }
};

// The kind of one lane, and all lanes of `open` that are of it.
RC_STEP Kind kindOf(const Shading &shading, size_t first, const SurfaceLanes &surface, M open) {
  const hal::SceneView &scene = shading.scene;
  const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bitsOf(FTag(), open));
  const auto [geometry, index] = hal::placeOf(scene, shading.hits.primitive[first + lane]);
  const hal::HotTriangle &triangle = geometry.triangles[index];
  const hal::MaterialRow *material = &hal::materialOf(scene, geometry, triangle);
  const int secondary = hal::secondaryKinds(*material, shading.last);
  if (surface.one) return {open, material, triangle.flags, secondary};
  const auto same = [&](U values, uint32_t value)
                        HWY_ATTR { return hn::RebindMask(FTag(), hn::Eq(values, hn::Set(UTag(), value))); };
  const M inSet = &geometry == &scene.geometry[0] ? hn::Not(surface.dynamic) : surface.dynamic;
  const M alike = hn::And(same(surface.material, triangle.material), same(surface.flags, triangle.flags));
  return {hn::And(open, hn::And(inSet, alike)), material, triangle.flags, secondary};
}

// What a texel makes of a colour of the material. [OpenGL ES 1.1, 3.7.12]
RC_STEP V3 textured(const hal::MaterialRow &material, const Rgb &colour, const TexelLanes &texel, F alpha) {
  const V3 plain = all(colour);
  switch (material.textureEnv) {
    case hal::TextureEnv::Replace:
      break;
    case hal::TextureEnv::Modulate:
      return plain * texel.rgb;
    case hal::TextureEnv::Decal:
      return mix(plain, texel.rgb, alpha);
    case hal::TextureEnv::Blend: {
      const V3 other = all(material.textureEnvColor);
      return {mix(plain.x, other.x, texel.rgb.x), mix(plain.y, other.y, texel.rgb.y),
              mix(plain.z, other.z, texel.rgb.z)};
    }
    case hal::TextureEnv::Add: {
      const V3 sum = plain + texel.rgb;
      return {hn::Min(sum.x, all(1)), hn::Min(sum.y, all(1)), hn::Min(sum.z, all(1))};
    }
  }
  return texel.rgb;
}

RC_STEP V3 bentNormals(const Shading &shading, const Kind &kind, const RayLanes &rays, const SurfaceLanes &surface) {
  const TexelLanes texel =
      sample(shading.scene, rays, surface, kind.lanes, kind.material->normalMap, kind.material->normalWrap);
  const V3 local = all(2) * texel.rgb - all(Vec3(1));
  V3 frame[3];
  for (size_t i = 0; i < 3; ++i) frame[i] = corner(surface.attributes, kNormalOffset, i);
  const V3 bent = local.x * frame[0] + local.y * frame[1] + local.z * frame[2];
  const M turned = hn::Lt(dot(frame[2], surface.flatNormal), zero());  // the ray came from behind
  return normalizedOr(negateWhere(turned, bent), surface.flatNormal);
}

// The surface's own colour: what it sends out, and what the lights make of it.
RC_STEP void shadeLocal(const Shading &shading, const hal::MaterialRow &material, const RayLanes &rays,
                        const SurfaceLanes &surface, const ColourLanes &colours, F &tolerance, M shaded) {
  const M local = hn::And(shaded, hn::Gt(maxComponent(colours.weight), zero()));
  if (none(local)) return;
  V3 own = colours.weight * (all(material.emission) + all(shading.scene.globalAmbient) * colours.ambient);
  const V3 view = -rays.direction;
  for (size_t i = 0; i < shading.scene.lights.size(); ++i) {
    addLight(shading, i, material, surface, view, colours, local, rays, tolerance, own);
  }
  addToPixels(own, local, rays.pixel, shading.out.sums);
}

RC_STEP void shadeSurface(const Shading &shading, const Kind &kind, const RayLanes &rays, const SurfaceLanes &surface,
                          const TexelLanes &texel, const V3 &weight, F tolerance, M shaded) {
  const hal::MaterialRow &material = *kind.material;
  if (kind.hasTexture() && kind.flags & hal::kTextureOnly) {
    return addToPixels(weight * texel.rgb, shaded, rays.pixel, shading.out.sums);
  }
  ColourLanes colours{all(material.ambient), all(material.diffuse), weight};
  if (kind.hasTexture()) {
    const F alpha = shading.scene.textures[size_t(material.texture)].hasAlpha ? texel.alpha : all(1);
    colours.ambient = textured(material, material.ambient, texel, alpha);
    colours.diffuse = textured(material, material.diffuse, texel, alpha);
  }
  if (kind.flags & hal::kHasColors) {
    colours.ambient = surface.color * colours.ambient;
    colours.diffuse = surface.color * colours.diffuse;
  }
  const bool whole = kind.secondary == 0;
  if (!whole) colours.weight = weight * all(Rgb(1) - material.reflection - material.transmittance);
  shadeLocal(shading, material, rays, surface, colours, tolerance, shaded);
  if (!whole) reflectAndRefract(shading, material, rays, surface, weight, tolerance, shaded);
}

// The lanes of one kind. straight: rays that went on behind an earlier hit.
RC_STEP void shadeKind(const Shading &shading, const Kind &kind, const RayLanes &rays, SurfaceLanes &surface,
                       M straight) {
  const hal::MaterialRow &material = *kind.material;
  TexelLanes texel;
  F there = all(1);
  if (kind.hasTexture()) {
    texel = sample(shading.scene, rays, surface, kind.lanes, material.texture, material.textureWrap);
    const float opaque = shading.scene.textures[size_t(material.texture)].opaqueAlpha;
    if (material.textureEnv != hal::TextureEnv::Decal) {
      there = hn::Min(hn::Div(hn::Mul(texel.alpha, all(255)), all(opaque)), all(1));
    }
  }
  there = coverage(kind.flags, surface, there);
  const M again = hn::And(straight, kind.lanes);
  M before = hn::Lt(there, zero());  // none
  if (!none(again)) {
    before = seenBefore(shading, rays.first, bitsOf(FTag(), again));
    there = hn::IfThenZeroElse(before, there);
  }
  if (kind.hasNormalMap())
    surface.normal = select(kind.lanes, bentNormals(shading, kind, rays, surface), surface.normal);

  const M missing = hn::And(kind.lanes, hn::Lt(there, all(1)));
  F tolerance = load(shading.rays.tolerance, rays.first);
  V3 weight = rays.weight;
  M shaded = kind.lanes;
  if (!none(missing)) {
    const M some = hn::Gt(there, zero());
    const F share = onlyWhere(missing, select(some, all(hal::straightShare(kind.secondary)), all(1)));
    goStraightOn(shading, rays, hn::Sub(all(1), there) * rays.weight, hn::Mul(tolerance, share), some,
                 hn::Or(some, before), missing);
    tolerance = hn::Mul(tolerance, hn::Sub(all(1), share));
    weight = there * rays.weight;
    shaded = hn::And(kind.lanes, hn::Gt(maxComponent(weight), zero()));
    if (none(shaded)) return;
  }
  if (shading.scene.fog.mode != hal::FogMode::Off) weight = throughFog(shading, rays, weight, shaded);
  shadeSurface(shading, kind, rays, surface, texel, weight, tolerance, shaded);
}

// One vector of rays.
RC_STEP void shadeVector(const Shading &shading, size_t first) {
  const M valid = lanesUpTo(FTag(), first, shading.rays.size());
  const RayLanes rays = loadRays(shading, first, valid);
  const M missed = hn::AndNot(rays.found, valid);
  if (!none(missed)) {
    addToPixels(rays.weight * all(shading.scene.clearColor), missed, rays.pixel, shading.out.sums);
    if (none(rays.found)) return;
  }
  const U after = load(shading.rays.afterPrimitive, first);
  const M fresh = hn::RebindMask(FTag(), hn::Eq(after, hn::Set(UTag(), hal::kNoPrimitive)));
  const M straight = hn::AndNot(fresh, rays.found);
  if (shading.out.bounces == 0) {
    shading.out.counts.primaryHits += hn::CountTrue(FTag(), hn::And(fresh, rays.found));
  }
  SurfaceLanes surface;
  surfaceOf(shading, rays, surface);
  for (M open = rays.found; !none(open);) {
    const Kind kind = kindOf(shading, first, surface, open);
    shadeKind(shading, kind, rays, surface, straight);
    open = hn::AndNot(kind.lanes, open);
  }
}

HWY_INLINE void makeRoom(const Shading &shading) {
  const size_t count = shading.rays.size();
  const hal::Outputs &out = shading.out;
  out.reflected.reserve(out.reflected.size() + count);
  out.refracted.reserve(out.refracted.size() + count);
  out.sameBounce.reserve(out.sameBounce.size() + count);
  for (size_t i = 0; i < shading.scene.lights.size(); ++i) out.shadows[i].reserve(out.shadows[i].size() + count);
}

// So few triangles, with their attributes, are in the second-level cache as it is.
constexpr size_t kFewTriangles = 1024;

// The triangles that rays from `first` on hit, once for each run of them. Returns how many; the list has room for a
// vector behind that many rays.
HWY_INLINE size_t listTriangles(const Shading &shading, size_t first, size_t end, uint32_t *list) {
  const UTag du;
  size_t size = 0;
  for (size_t i = first; i < end; i += lanes()) {
    const U primitive = load(shading.hits.primitive, i), next = load(shading.hits.primitive, i + 1);
    const auto hit = hn::And(lanesUpTo(du, i, end), hn::Ne(primitive, hn::Set(du, hal::kNoPrimitive)));
    const auto repeated = hn::And(lanesUpTo(du, i + 1, end), hn::Eq(primitive, next));
    const auto last = hn::AndNot(repeated, hit);
    hn::StoreU(packed(du, primitive, last), du, list + size);
    size += hn::CountTrue(du, last);
  }
  return size;
}

// Starts to fetch the triangles that were hit: when their vectors are shaded, they are there. They are listed first:
// where a list ends is foretold wrong but once, where the few of each vector end, again and again.
HWY_INLINE void prefetchTriangles(const Shading &shading) {
  const auto &sets = shading.scene.geometry;
  if (sets[0].triangles.size() + sets[1].triangles.size() <= kFewTriangles) return;
  const bool textured = !shading.scene.textures.empty();
  constexpr size_t kAtOnce = 256;
  uint32_t list[kAtOnce + kMostLanes];
  for (size_t first = 0; first < shading.rays.size(); first += kAtOnce) {
    const size_t size = listTriangles(shading, first, std::min(first + kAtOnce, shading.rays.size()), list);
    for (size_t i = 0; i < size; ++i) {
      const auto [geometry, index] = hal::placeOf(shading.scene, list[i]);
      hwy::Prefetch(geometry.triangles.data() + index);
      if (textured || geometry.interpolates) hwy::Prefetch(geometry.attributes.data() + index);
    }
  }
}

HWY_INLINE void shadeBatch(const Shading &shading) {
  makeRoom(shading);
  prefetchTriangles(shading);
  for (size_t first = 0; first < shading.rays.size(); first += lanes()) shadeVector(shading, first);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
