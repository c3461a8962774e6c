// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rays.h: the rays of the measurements, by kind; the same for every tracer.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "peers/soup.h"

namespace rc::bench {

enum Kind { kPrimary, kShadow, kFromLight, kMirror, kDiffuse, kKinds };
inline constexpr const char *kKindNames[kKinds] = {"primary", "shadow", "from light", "mirror", "diffuse"};

// Whether rays ask only if something is in the way, and whether they are known to have one origin.
inline bool asksBlocked(Kind kind) { return kind == kShadow || kind == kFromLight; }
inline bool haveOneOrigin(Kind kind) { return kind == kPrimary || kind == kFromLight; }

// Columns, 64-byte aligned; the count is a multiple of 256: the last rays are repeated.
class RayBatch {
 public:
  static constexpr size_t kColumns = 7;

  RayBatch() = default;
  explicit RayBatch(size_t reserve) { mRays.reserve(reserve); }

  void add(const Vec3 &origin, const Vec3 &direction, float tMax, uint32_t from) {
    mRays.push_back({origin, direction, tMax, from});
  }
  // Puts what was added into the columns.
  void finish();

  size_t size() const { return mCount; }
  float *column(size_t i) const { return mStart + i * mCount; }  // ox oy oz dx dy dz tMax
  Vec3 origin(size_t i) const { return {column(0)[i], column(1)[i], column(2)[i]}; }
  Vec3 direction(size_t i) const { return {column(3)[i], column(4)[i], column(5)[i]}; }
  float tMax(size_t i) const { return column(6)[i]; }
  const uint32_t *from() const { return mFrom.data(); }  // the triangle each ray is about and cannot meet; kMiss: none

 private:
  struct Item {
    Vec3 origin, direction;
    float tMax;
    uint32_t from;
  };
  std::vector<Item> mRays;
  std::vector<float> mMemory;
  std::vector<uint32_t> mFrom;
  float *mStart = nullptr;
  size_t mCount = 0;
};

struct FirstHit {
  float t;
  uint32_t primitive;  // kMiss: none
};
inline constexpr uint32_t kMiss = 0xffffffff;

// In tiles of 16 x 16 pixels, these in blocks of 4 x 4.
RayBatch primaryRays(const Soup &soup, int width, int height);

// The kinds for where primary rays end: to and from a point light, a mirror everywhere, diffuse (seeded).
RayBatch secondaryRays(const Soup &soup, Kind kind, const RayBatch &primary, std::span<const FirstHit> hits);

}  // namespace rc::bench
