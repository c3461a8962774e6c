// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tolerance.h: which rays are left out, and how those that leave a hit share what may be left out behind it
// (RayItem::tolerance): all that is left out, however many rays that are, weighs no more than what a pixel may be off.
// In: what may be left out, weights of rays.  Out: what may be left out of each.
#pragma once

#include <algorithm>
#include <cmath>

#include "rchal/scene_view.h"

namespace rc::hal {

inline constexpr float kStep = 1.0f / 256;  // of a byte, or a little less

inline int secondaryKinds(const MaterialRow &material, bool last) {
  return last ? 0 : (maxComponent(material.reflection) > 0) + (maxComponent(material.transmittance) > 0);
}

// Of a ray that goes straight on through what is there in part: as much as for each of the others.
inline float straightShare(int secondaryKinds) { return 1 / static_cast<float>(secondaryKinds + 1); }

// The lighter one of two rays gets more: as soon as it is left out, what it leaves over is the other's. Measured: with
// halves, glass takes a tenth more rays.
struct TwoShares {
  float reflected, refracted;  // 1 together
};
inline TwoShares sharesOf(const MaterialRow &material) {
  const float reflected = std::sqrt(maxComponent(material.reflection));
  const float refracted = std::sqrt(maxComponent(material.transmittance));
  const float sum = reflected + refracted;
  return sum > 0 ? TwoShares{refracted / sum, reflected / sum} : TwoShares{0, 0};
}

// What may be left out of one of two rays: all but the share of the other, which lacks its weight at most. If both then
// are left out that weigh no more, both together never take more than `tolerance`.
inline float besides(float tolerance, float otherWeight, float otherShare) {
  return tolerance - std::min(otherWeight, otherShare * tolerance);
}

// The most that a ray may weigh which is left out by itself: half a step of a byte.
inline float mostLeftOut(const SceneView &scene) { return 0.5f * scene.ignorable; }

// What light weighs: as much as a ray that brings so much at the most. Where it weighs less than a ray which is left
// out, nobody asks whether something is in its way: it arrives.
inline float weightOf(const SceneView &scene, float light) { return light * (scene.ignorable / kStep); }

// Where every hit of a ray makes two or three, their number grows as a power of the hits on the way: bounces, and
// layers that were there in part. The parts of what may be left out shrink as fast. After so many hits only rays count
// that weigh enough: 4096 of them share what a pixel shows, not 2^31.
inline constexpr int kFreeHits = 12;
inline constexpr float kLeastAfterwards = 1.0f / 4096;
inline float leastWeight(const SceneView &scene, int hits) {
  return hits < kFreeHits ? scene.minWeight : std::max(scene.minWeight, kLeastAfterwards);
}

}  // namespace rc::hal
