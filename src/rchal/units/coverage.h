// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// coverage.h: how much of a surface is there for a ray: culled sides, the alpha test, transparent texels.
// One rule for the rays that see and for those that ask for shadow. [spec 3.4, 3.8; OpenGL ES 1.1, 3.5.1, 4.1.4]
// In: flags of the triangle, the side that is met, opacity.  Out: 0 ... 1.  Next: units/shading.h, units/shadow.h
#pragma once

#include "rchal/device.h"

namespace rc::hal {

// The alpha test in the flags: which outcomes of "opacity against reference" pass. 0 stands for all of them, so that
// triangles without a test have no flag, and kAlphaNever for none.
enum AlphaOutcome : uint32_t { kAlphaLess = 1, kAlphaEqual = 2, kAlphaGreater = 4, kAlphaNever = 7 };

// 0 ... 1 in 255ths, as the texels of most textures have it.
inline uint32_t in255ths(float share) { return static_cast<uint32_t>(std::floor(share * 255 + 0.5f)); }

// Flags of an alpha test. outcomes: those of AlphaOutcome that pass, 0 (none) ... 7 (all); reference: 0 ... 1.
inline uint32_t alphaTestFlags(uint32_t outcomes, float reference) {
  if (outcomes == 7) return 0;
  const uint32_t code = outcomes == 0 ? uint32_t{kAlphaNever} : outcomes;
  return code << kAlphaTestShift | in255ths(std::clamp(reference, 0.0f, 1.0f)) << kAlphaReferenceShift;
}

// opacity: 0 ... 1.
inline bool passesAlphaTest(uint32_t flags, float opacity) {
  const uint32_t code = (flags & kAlphaTestMask) >> kAlphaTestShift;
  if (code == 0) return true;
  if (code == kAlphaNever) return false;
  const uint32_t level = in255ths(opacity);
  const uint32_t reference = flags >> kAlphaReferenceShift & 255;
  return code & (level < reference ? kAlphaLess : level == reference ? kAlphaEqual : kAlphaGreater);
}

// A culled side, and what fails the alpha test, is not there for any ray.
inline float coverage(uint32_t flags, bool front, float opacity) {
  if (flags & (front ? kCullFront : kCullBack)) return 0;
  return passesAlphaTest(flags, opacity) ? opacity : 0;
}

// Whether a ray meets the front: the counter-clockwise side, unless rcFrontFace says otherwise.
inline bool meetsFront(uint32_t flags, const Vec3 &flatNormal, const Vec3 &direction) {
  return (glm::dot(flatNormal, direction) < 0) == ((flags & kClockwiseFront) == 0);
}

// What a triangle is for a ray that looks for light: in the way, or not there, or it has to be looked at.
enum class Passage { Blocked, Free, Filtered };

inline Passage passageOf(const GeometryView &geometry, uint32_t index, const Vec3 &direction) {
  const uint32_t flags = geometry.triangles[index].flags, sides = kCullFront | kCullBack;
  if ((flags & kFiltersShadow) == 0) return Passage::Blocked;
  if (flags & sides) {
    const bool front = meetsFront(flags, geometry.triangles[index].flatNormal, direction);
    if (flags & (front ? kCullFront : kCullBack)) return Passage::Free;
  }
  return flags & kFiltersShadow & ~sides ? Passage::Filtered : Passage::Blocked;
}

// Whether two hits in a row belong to one surface, met at the common edge of two of its triangles: it counts once.
inline bool isSameSurface(const SceneView &scene, const HitOrder &previous, const Hit &hit) {
  if (previous.primitive == kNoPrimitive) return false;
  constexpr float kSameDistance = 0x1p-21f;  // of the distance
  const auto material = [&](uint32_t primitive) {
    const PrimitivePlace place = placeOf(scene, primitive);
    return &materialOf(scene, place.geometry, place.geometry.triangles[place.index]);
  };
  return hit.t - previous.t <= hit.t * kSameDistance && material(previous.primitive) == material(hit.primitive);
}

}  // namespace rc::hal
