// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// shading.h: the shading unit: colour of one hit, and the rays it asks for. [spec 3.4, 3.5, 4; G 6, 7]
// In: SceneView, RayItem, Hit.  Out: colours into Outputs::sums, shadow and secondary rays into its queues.
// Next: rchal/tile_tracer.h sends the shadow rays to the traversal unit and the others round again.
#pragma once

#include "rchal/units/coverage.h"
#include "rchal/units/fog.h"
#include "rchal/units/footprint.h"
#include "rchal/units/lighting.h"
#include "rchal/units/shadow_ray.h"
#include "rchal/units/tolerance.h"

namespace rc::hal {

struct Outputs {
  PixelSums sums;
  std::span<ShadowQueue> shadows;   // by light
  RayQueue &sameBounce;             // rays that go straight on
  RayQueue &reflected, &refracted;  // rays of the next generation
  RayCounts &counts;
  int bounces;  // of the rays whose hits these are: how often they were reflected or refracted
};

class Shader {
 public:
  Shader(const SceneView &scene, const RayItem &item, const Hit &hit, const Outputs &out)
      : mScene(scene),
        mItem(item),
        mHit(hit),
        mOut(out),
        mView(-item.ray.direction),
        mConeWidth(std::abs(item.coneWidth + item.coneSpread * hit.t)),
        mConeSpread(item.coneWidth + item.coneSpread * hit.t < 0 ? -item.coneSpread : item.coneSpread) {
    const auto [geometry, index] = placeOf(scene, hit.primitive);
    mTriangle = &geometry.triangles[index];
    mMaterial = &materialOf(scene, geometry, *mTriangle);
    mPoint = surfacePoint(geometry, index, hit, item.ray.direction);
    mAttributes = &geometry.attributes[index];
    if (mMaterial->texture != kNoTexture) readTexel();
    mCoverage = coverage(mTriangle->flags, mPoint.front, mCoverage);
    mSeenBefore = item.afterSeen && isSameSurface(scene, item.after, hit);
    if (mSeenBefore) mCoverage = 0;
    if (mCoverage <= 0) {
      mStraightShare = 1;
    } else if (mCoverage < 1) {
      mStraightShare = straightShare(secondaryKinds(*mMaterial, out.bounces >= scene.maxBounces));
    }
    mTolerance = item.tolerance * (1 - mStraightShare);
    if (mTriangle->flags & kTangentFrame && mMaterial->normalMap != kNoTexture) bendNormal();
  }

  void shade() {
    if (mCoverage < 1) goStraightOn();
    if (maxComponent(mItem.weight * mCoverage) <= 0) return;
    const Rgb weight = throughFog(mItem.weight * mCoverage);
    if (mTextured && mTriangle->flags & kTextureOnly) {
      add(weight * mTexel);
      return;
    }
    // At the last generation a surface shows its own colour only.
    const bool last = mOut.bounces >= mScene.maxBounces;
    shadeLocal(last ? weight : weight * (Rgb(1) - mMaterial->reflection - mMaterial->transmittance));
    if (last) return;
    reflectAndRefract(weight * mMaterial->reflection, weight * mMaterial->transmittance);
  }

 private:
  void add(const Rgb &colour) { mOut.sums.add(mItem.pixel, colour); }

  // What the fog leaves of the surface; it adds its own light.
  Rgb throughFog(const Rgb &weight) {
    if (mScene.fog.mode == FogMode::Off) return weight;
    const float left = fogLeft(mScene.fog, mItem.travelled, mHit.t, mOut.bounces == 0);
    add(weight * (1 - left) * mScene.fog.color);
    return weight * left;
  }

  void readTexel() {
    const TextureView &texture = mScene.textures[size_t(mMaterial->texture)];
    const Vec4 texel = sample(texture, mMaterial->textureWrap);
    mTexel = Rgb(texel);
    mTexelAlpha = texture.hasAlpha ? texel.w : 1;
    mCoverage = opacityOf(*mMaterial, texture, texel.w);
    mTextured = true;
  }

  Vec4 sample(const TextureView &texture, const Wraps &wraps) const {
    if (!mScene.mipmaps || texture.levelCount == 1) return sampleTexture(texture, mPoint.uv, wraps, 0);
    if (texture.anisotropy > 1) {
      const Footprint footprint =
          stretchedFootprint(*mTriangle, *mAttributes, texture, mPoint.flatNormal, -mView, mConeWidth);
      return sampleFootprint(texture, mPoint.uv, wraps, footprint);
    }
    const float cosine = std::abs(glm::dot(mPoint.flatNormal, mView));
    return sampleTexture(texture, mPoint.uv, wraps,
                         levelOfDetail(*mTriangle, *mAttributes, texture, mConeWidth, cosine));
  }

  // A normal map holds 2 c - 1 along the tangent, the bitangent and the normal of its triangle.
  void bendNormal() {
    const TextureView &texture = mScene.textures[size_t(mMaterial->normalMap)];
    const Vec3 local = 2.0f * Vec3(sample(texture, mMaterial->normalWrap)) - 1.0f;
    const Vec3 bent =
        local.x * mAttributes->normal[0] + local.y * mAttributes->normal[1] + local.z * mAttributes->normal[2];
    const bool turned = glm::dot(mAttributes->normal[2], mPoint.flatNormal) < 0;  // the ray came from behind
    mPoint.normal = normalizedOr(turned ? -bent : bent, mPoint.flatNormal);
  }

  // What a texel makes of a colour of the material. [OpenGL ES 1.1, 3.7.12]
  Rgb textured(const Rgb &colour) const {
    if (!mTextured) return colour;
    switch (mMaterial->textureEnv) {
      case TextureEnv::Replace:
        return mTexel;
      case TextureEnv::Modulate:
        return colour * mTexel;
      case TextureEnv::Decal:
        return glm::mix(colour, mTexel, mTexelAlpha);
      case TextureEnv::Blend:
        return glm::mix(colour, mMaterial->textureEnvColor, mTexel);
      case TextureEnv::Add:
        return glm::min(colour + mTexel, 1.0f);
    }
    return mTexel;
  }

  void shadeLocal(const Rgb &weight) {
    if (maxComponent(weight) <= 0) return;
    const SurfaceColours colours{mPoint.color * textured(mMaterial->ambient),
                                 mPoint.color * textured(mMaterial->diffuse), mMaterial->specular, mMaterial->shininess,
                                 mMaterial->leastShine};
    add(weight * (mMaterial->emission + mScene.globalAmbient * colours.ambient));
    for (size_t i = 0; i < mScene.lights.size(); ++i) {
      const LightRow &light = mScene.lights[i];
      const LightTerm term = lightAt(light, mPoint, mView, colours);
      add(weight * term.ambient);
      const Rgb direct = weight * term.direct;
      if (maxComponent(direct) <= 0) continue;
      if (!mScene.shadows || !light.castsShadow || isWeak(direct)) {
        add(direct);
        continue;
      }
      mOut.shadows[i].push({shadowRay(light, mPoint, term), direct, mItem.pixel, mHit.primitive});
      ++mOut.counts.shadow;
    }
  }

  // Whether its shadow may be left out; then what else may be is less.
  bool isWeak(const Rgb &light) {
    const float weight = weightOf(mScene, maxComponent(light));
    if (weight >= std::min(mTolerance, mostLeftOut(mScene))) return false;
    mTolerance -= weight;
    return true;
  }

  // The same ray, for what lies behind this hit.
  void goStraightOn() {
    RayItem next = mItem;
    next.after = {mHit.t, mHit.primitive};
    next.afterSeen = mCoverage > 0 || mSeenBefore;  // more than two triangles may meet where the ray passes
    next.weight = mItem.weight * (1 - mCoverage);
    next.tolerance = mItem.tolerance * mStraightShare;
    next.layers += mCoverage > 0;
    if (mCoverage > 0 && !counts(next.weight, next.tolerance, next.layers)) return;
    mOut.sameBounce.push(next);
    ++mOut.counts.straight;
  }

  // Whether a ray of this weight, behind so many layers, is worth tracing.
  bool counts(const Rgb &weight, float tolerance, uint32_t layers) const {
    const float strongest = maxComponent(weight);
    return strongest > std::min(tolerance, mostLeftOut(mScene)) &&
           strongest >= leastWeight(mScene, mOut.bounces + static_cast<int>(layers));
  }

  float curvatureHere() const { return curvature(*mTriangle, *mAttributes, mPoint.flatNormal); }

  void reflect(const Rgb &weight, float tolerance) {
    if (!counts(weight, tolerance, mItem.layers)) return;
    const Vec3 d = mItem.ray.direction;
    Vec3 mirrored = d - 2 * glm::dot(d, mPoint.normal) * mPoint.normal;
    // An interpolated normal can send the ray into the surface: it is then led along it.
    const float height = glm::dot(mirrored, mPoint.flatNormal);
    if (height <= 0) mirrored += (1e-3f - height) * mPoint.flatNormal;
    bounce(weight, tolerance, mirrored, reflectedSpread(mConeSpread, mConeWidth, curvatureHere()), mOut.reflected);
    ++mOut.counts.reflected;
  }

  // Snell's law, index n against 1 outside; the front side leads in, the back side out. [spec 4]
  // Total reflection sends both shares along the mirror direction, in one ray.
  void reflectAndRefract(const Rgb &reflected, const Rgb &refracted) {
    const float eta = mPoint.front ? 1 / mMaterial->refractionIndex : mMaterial->refractionIndex;
    const float cosine = -glm::dot(mItem.ray.direction, mPoint.normal);
    const float k = 1 - eta * eta * (1 - cosine * cosine);
    if (k < 0) return reflect(reflected + refracted, mTolerance);
    const TwoShares shares = sharesOf(*mMaterial);
    reflect(reflected, besides(mTolerance, maxComponent(refracted), shares.refracted));
    const float left = besides(mTolerance, maxComponent(reflected), shares.reflected);
    if (!counts(refracted, left, mItem.layers)) return;
    Vec3 bent = eta * mItem.ray.direction + (eta * cosine - std::sqrt(k)) * mPoint.normal;
    const float depth = glm::dot(bent, mPoint.flatNormal);
    if (depth >= 0) bent -= (depth + 1e-3f) * mPoint.flatNormal;
    bounce(refracted, left, bent, refractedSpread(mConeSpread, mConeWidth, curvatureHere(), eta), mOut.refracted);
    ++mOut.counts.refracted;
  }

  void bounce(const Rgb &weight, float tolerance, const Vec3 &direction, float coneSpread, RayQueue &queue) {
    RayItem next = mItem;
    next.ray.direction = directionOf(direction, mPoint.flatNormal);
    next.ray.origin = mPoint.start(next.ray.direction);
    next.weight = weight;
    next.tolerance = tolerance;
    next.after = {};
    next.afterSeen = false;
    next.coneWidth = mConeWidth;
    next.coneSpread = coneSpread;
    next.travelled += mHit.t;
    queue.push(next);
  }

  const SceneView &mScene;
  const RayItem &mItem;
  const Hit &mHit;
  const Outputs &mOut;
  Vec3 mView;
  float mConeWidth, mConeSpread;  // at the hit; behind a focus the cone widens again
  const HotTriangle *mTriangle;
  const TriangleAttributes *mAttributes;
  const MaterialRow *mMaterial;
  SurfacePoint mPoint;
  Rgb mTexel{0};
  float mTexelAlpha = 1;
  float mCoverage = 1;       // share of the surface that is there
  float mStraightShare = 0;  // of what may be left out: for what goes straight on
  float mTolerance;          // what is left of it for the rest
  bool mTextured = false;
  bool mSeenBefore;  // as another triangle of the same surface
};

// What becomes of one ray whose nearest hit is known.
inline void shadeRay(const SceneView &scene, const RayItem &item, const Hit &hit, const Outputs &out) {
  if (!hit.found()) {
    out.sums.add(item.pixel, item.weight * scene.clearColor);
    return;
  }
  if (out.bounces == 0 && item.after.primitive == kNoPrimitive) ++out.counts.primaryHits;
  Shader(scene, item, hit, out).shade();
}

}  // namespace rc::hal
