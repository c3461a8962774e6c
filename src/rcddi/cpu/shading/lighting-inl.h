// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lighting-inl.h: units/lighting.h for lanes: Phong's model, a light at a time.
// In: LightRow, SurfaceLanes, colours.  Out: colours, and questions about shadow into the light's queue.
// Next: shade-inl.h
#if defined(RAYCORE_SHADING_LIGHTING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_LIGHTING_INL
#undef RAYCORE_SHADING_LIGHTING_INL
#else
#define RAYCORE_SHADING_LIGHTING_INL
#endif

#include "rcddi/cpu/shading/surface-inl.h"
#include "rchal/units/shadow_ray.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// What the lights meet; weight is what the pixel gets of it.
struct ColourLanes {
  V3 ambient, diffuse;
  V3 weight;
};

RC_STEP F spotFactor(const hal::LightRow &light, const V3 &direction) {
  if (!light.spot) return all(1);
  const F cosine = dot(-direction, all(light.spotDirection));
  const F s = hn::Div(hn::Sub(cosine, all(light.cosOuter)), all(light.cosInner - light.cosOuter));
  const F step = hn::Mul(hn::Mul(s, s), hn::Sub(all(3), hn::Mul(all(2), s)));
  const F edge = select(hn::Lt(cosine, all(light.cosInner)), step, all(1));
  const F factor = hn::Mul(edge, powOf(hn::Max(cosine, zero()), all(light.spotExponent)));
  return onlyWhere(hn::Ge(cosine, all(light.cosOuter)), factor);
}

RC_STEP F attenuation(const hal::LightRow &light, F distance) {
  if (light.directional) return all(1);
  F factor;
  if (light.fades()) {
    const F polynomial = hn::Add(all(light.linear), hn::Mul(distance, all(light.quadratic)));
    const F divisor = hn::Add(all(light.constant), hn::Mul(distance, polynomial));
    factor = select(hn::Gt(divisor, zero()), hn::Div(all(1), divisor), all(1));
  } else {
    factor = all(light.constant > 0 ? 1 / light.constant : 1);
  }
  if (light.rangeEnd <= light.rangeStart) return factor;
  const F left = hn::Div(hn::Sub(all(light.rangeEnd), distance), all(light.rangeEnd - light.rangeStart));
  return hn::Mul(factor, hn::Min(hn::Max(left, zero()), all(1)));
}

HWY_INLINE bool isDark(const Rgb &colour) { return !(rc::maxComponent(colour) > 0); }

// What a light is to the points.
struct LightTerms {
  V3 towards, direction;
  F distance;
};

// units/shadow_ray.h
RC_STEP size_t pushShadowRays(const hal::LightRow &light, const SurfaceLanes &surface, const LightTerms &term,
                              const V3 &colour, const RayLanes &rays, M asked, hal::ShadowQueue &queue) {
  return append(asked, queue, [&](auto &&put) HWY_ATTR {
    if (light.sendsShadowRays) {
      const F endOffset = hn::Max(surface.safeOffset, hn::Mul(all(hal::kPositionError), term.distance));
      put(offset(surface, term.direction, endOffset) - term.towards, queue.direction);
    } else {
      put(start(surface, term.direction), queue.origin);
      put(term.towards, queue.direction);
    }
    put(colour, queue.colour);
    put(rays.pixel, queue.pixel);
    put(rays.primitive, queue.from);
  });
}

// Adds a light of the scene to `own` where no shadow can be or none would show; asks its queue elsewhere.
RC_STEP void addLight(const Shading &shading, size_t place, const hal::MaterialRow &material,
                      const SurfaceLanes &surface, const V3 &view, const ColourLanes &colours, M shaded,
                      const RayLanes &rays, F &tolerance, V3 &own) {
  const hal::SceneView &scene = shading.scene;
  const hal::LightRow &light = scene.lights[place];
  const V3 towards = light.directional ? all(light.position) : all(light.position) - surface.position;
  const F distance = light.directional ? all(kInfinity) : length(towards);
  const V3 direction = light.directional ? towards : directionOf(towards, distance, surface.normal);
  const F strength = hn::Mul(attenuation(light, distance), spotFactor(light, direction));
  if (!isDark(light.ambient)) {
    own = own + colours.weight * ((strength * colours.ambient) * all(light.ambient));
  }
  const F cosine = dot(surface.normal, direction);
  const M facing = hn::And(shaded, hn::Gt(cosine, zero()));
  if (none(facing)) return;
  V3 direct = colours.diffuse * all(light.diffuse);
  const Rgb highlight = material.specular * light.specular;
  if (!isDark(highlight)) {
    // The direction mirrored by the normal, times the view.
    const F towardsView = hn::Sub(hn::Mul(hn::Mul(all(2), cosine), dot(surface.normal, view)), dot(direction, view));
    const M shines = hn::And(facing, hn::Gt(towardsView, all(material.leastShine)));
    if (!none(shines)) {
      const F power = powOf(hn::Max(towardsView, zero()), all(material.shininess));
      direct = direct + onlyWhere(shines, power) * all(highlight);
    }
  }
  direct = colours.weight * (hn::Mul(strength, cosine) * direct);
  const F strongest = maxComponent(direct);
  M lit = hn::And(facing, hn::Gt(strongest, zero()));
  if (none(lit)) return;
  if (scene.shadows && light.castsShadow) {
    const F weight = hn::Mul(strongest, all(hal::weightOf(scene, 1)));
    const M weak = hn::And(lit, hn::Lt(weight, hn::Min(tolerance, all(hal::mostLeftOut(scene)))));
    const M asked = hn::AndNot(weak, lit);
    if (!none(asked)) {
      shading.out.counts.shadow += pushShadowRays(light, surface, {towards, direction, distance}, direct, rays, asked,
                                                  shading.out.shadows[place]);
    }
    if (none(weak)) return;
    tolerance = hn::Sub(tolerance, onlyWhere(weak, weight));
    lit = weak;
  }
  own = own + onlyWhere(lit, direct);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
