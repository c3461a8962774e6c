// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// secondary-inl.h: the rays that hits ask for: straight on, reflected, refracted. (units/shading.h)
// In: RayLanes, SurfaceLanes.  Out: RayQueues.  Next: rchal/tile_tracer.h
#if defined(RAYCORE_SHADING_SECONDARY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_SECONDARY_INL
#undef RAYCORE_SHADING_SECONDARY_INL
#else
#define RAYCORE_SHADING_SECONDARY_INL
#endif

#include "rcddi/cpu/shading/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

// The hit that rays go on behind: where, of what triangle, and whether something of it was seen.
struct AfterHit {
  F t;
  U primitive, seen;
};
HWY_INLINE AfterHit afterNone() { return {zero(), hn::Set(UTag(), hal::kNoPrimitive), hn::Zero(UTag())}; }

// A ray for each lane of the mask; the queue has room for a vector. Returns how many.
RC_STEP size_t pushRays(const V3 &origin, const V3 &direction, const V3 &weight, F coneWidth, F coneSpread, F travelled,
                        F tolerance, U layers, U pixel, const AfterHit &after, M asked, hal::RayQueue &queue) {
  return append(asked, queue, [&](auto &&put) HWY_ATTR {
    put(origin, queue.origin);
    put(direction, queue.direction);
    put(weight, queue.weight);
    put(coneWidth, queue.coneWidth);
    put(coneSpread, queue.coneSpread);
    put(travelled, queue.travelled);
    put(tolerance, queue.tolerance);
    put(layers, queue.layers);
    put(pixel, queue.pixel);
    put(after.t, queue.afterT);
    put(after.primitive, queue.afterPrimitive);
    put(after.seen, queue.afterSeen);
  });
}

// Lanes whose rays, behind so many layers, are worth tracing.
HWY_INLINE M worthTracing(const Shading &shading, const V3 &weight, F tolerance, U layers, M asked) {
  const U hits = hn::Add(layers, hn::Set(UTag(), static_cast<uint32_t>(shading.out.bounces)));
  const M free = hn::RebindMask(FTag(), hn::Lt(hits, hn::Set(UTag(), uint32_t{hal::kFreeHits})));
  const F least =
      select(free, all(hal::leastWeight(shading.scene, 0)), all(hal::leastWeight(shading.scene, hal::kFreeHits)));
  const F strongest = maxComponent(weight), leftOut = hn::Min(tolerance, all(hal::mostLeftOut(shading.scene)));
  return hn::And(asked, hn::And(hn::Gt(strongest, leftOut), hn::Ge(strongest, least)));
}

// The same rays, for what lies behind these hits. weight: what is left for them; there: lanes that hit something that
// is there; seen: and those that saw it before.
RC_STEP void goStraightOn(const Shading &shading, const RayLanes &rays, const V3 &weight, F tolerance, M there, M seen,
                          M missing) {
  const hal::RayQueue &from = shading.rays;
  const U one = hn::Set(UTag(), 1);
  const U layers = hn::Add(load(from.layers, rays.first), hn::IfThenElseZero(hn::RebindMask(UTag(), there), one));
  const M asked = hn::And(missing, hn::Or(hn::Not(there), worthTracing(shading, weight, tolerance, layers, missing)));
  const AfterHit after{rays.t, rays.primitive, hn::IfThenElseZero(hn::RebindMask(UTag(), seen), one)};
  shading.out.counts.straight +=
      pushRays(load(from.origin, rays.first), rays.direction, weight, load(from.coneWidth, rays.first),
               load(from.coneSpread, rays.first), load(from.travelled, rays.first), tolerance, layers, rays.pixel,
               after, asked, shading.out.sameBounce);
}

class Secondary {
 public:
  HWY_INLINE Secondary(const Shading &shading, const RayLanes &rays, const SurfaceLanes &surface, M asked)
      : mShading(shading),
        mRays(rays),
        mSurface(surface),
        mLayers(load(shading.rays.layers, rays.first)),
        mTravelled(hn::Add(load(shading.rays.travelled, rays.first), rays.t)),
        mCurvature(shading.cones ? curvature(surface, asked) : zero()) {}

  RC_STEP void reflect(const V3 &weight, F tolerance, M asked) const {
    const M traced = worthTracing(mShading, weight, tolerance, mLayers, asked);
    if (none(traced)) return;
    const V3 &d = mRays.direction;
    V3 mirrored = d - hn::Mul(all(2), dot(d, mSurface.normal)) * mSurface.normal;
    const F height = dot(mirrored, mSurface.flatNormal);
    const V3 led = mirrored + hn::Sub(all(1e-3f), height) * mSurface.flatNormal;
    mirrored = select(hn::Le(height, zero()), led, mirrored);
    const F turn = hn::Mul(hn::Mul(all(2), mCurvature), mRays.coneWidth);
    mShading.out.counts.reflected +=
        bounce(weight, tolerance, mirrored, hn::Add(mRays.coneSpread, turn), traced, mShading.out.reflected);
  }

  // eta: index before / index behind; root: the square root of Snell's law.
  RC_STEP void refract(const V3 &weight, F tolerance, F eta, F cosine, F root, M asked) const {
    const M traced = worthTracing(mShading, weight, tolerance, mLayers, asked);
    if (none(traced)) return;
    V3 bent = eta * mRays.direction + hn::Sub(hn::Mul(eta, cosine), root) * mSurface.normal;
    const F depth = dot(bent, mSurface.flatNormal);
    const V3 led = bent - hn::Add(depth, all(1e-3f)) * mSurface.flatNormal;
    bent = select(hn::Ge(depth, zero()), led, bent);
    const F turn = hn::Mul(hn::Mul(hn::Sub(eta, all(1)), mCurvature), mRays.coneWidth);
    mShading.out.counts.refracted +=
        bounce(weight, tolerance, bent, hn::Add(hn::Mul(eta, mRays.coneSpread), turn), traced, mShading.out.refracted);
  }

 private:
  HWY_INLINE size_t bounce(const V3 &weight, F tolerance, const V3 &direction, F coneSpread, M traced,
                           hal::RayQueue &queue) const {
    const V3 unit = directionOf(direction, mSurface.flatNormal);
    return pushRays(start(mSurface, unit), unit, weight, mRays.coneWidth, coneSpread, mTravelled, tolerance, mLayers,
                    mRays.pixel, afterNone(), traced, queue);
  }

  const Shading &mShading;
  const RayLanes &mRays;
  const SurfaceLanes &mSurface;
  U mLayers;
  F mTravelled, mCurvature;
};

// units/tolerance.h
HWY_INLINE F besides(F tolerance, const V3 &otherWeight, float otherShare) {
  return hn::Sub(tolerance, hn::Min(maxComponent(otherWeight), hn::Mul(all(otherShare), tolerance)));
}

// weight: of what arrives at the surface.
RC_STEP void reflectAndRefract(const Shading &shading, const hal::MaterialRow &material, const RayLanes &rays,
                               const SurfaceLanes &surface, const V3 &weight, F tolerance, M shaded) {
  const Secondary secondary(shading, rays, surface, shaded);
  const V3 reflected = weight * all(material.reflection);
  if (rc::maxComponent(material.transmittance) <= 0) return secondary.reflect(reflected, tolerance, shaded);
  const V3 refracted = weight * all(material.transmittance);
  const F eta = select(surface.front, all(1 / material.refractionIndex), all(material.refractionIndex));
  const F cosine = hn::Neg(dot(rays.direction, surface.normal));
  const F sine2 = hn::Sub(all(1), hn::Mul(cosine, cosine));
  const F k = hn::Sub(all(1), hn::Mul(hn::Mul(eta, eta), sine2));
  const M total = hn::Lt(k, zero());
  const hal::TwoShares shares = hal::sharesOf(material);
  const F ofReflected = select(total, tolerance, besides(tolerance, refracted, shares.refracted));
  secondary.reflect(select(total, reflected + refracted, reflected), ofReflected, shaded);
  secondary.refract(refracted, besides(tolerance, reflected, shares.reflected), eta, cosine,
                    hn::Sqrt(hn::Max(k, zero())), hn::AndNot(total, shaded));
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
