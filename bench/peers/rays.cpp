// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "peers/rays.h"

#include <random>

namespace rc::bench {
namespace {

constexpr float kFar = 1e30f;
constexpr float kToLight = 0.9995f, kFromSurface = 0.99999f;  // of the way between a light and a surface

// Directions with the density of the cosine around the normal.
class CosineLobe {
 public:
  Vec3 operator()(const Vec3 &normal) {
    const float angle = 6.2831853f * mUnit(mRandom), square = mUnit(mRandom), radius = std::sqrt(square);
    const Vec3 axis = std::abs(normal.x) > 0.5f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 side = glm::normalize(glm::cross(normal, axis)), up = glm::cross(normal, side);
    return glm::normalize(side * (std::cos(angle) * radius) + up * (std::sin(angle) * radius) +
                          normal * std::sqrt(1 - square));
  }

 private:
  std::mt19937 mRandom{7};
  std::uniform_real_distribution<float> mUnit{0, 1};
};

}  // namespace

void RayBatch::finish() {
  const size_t count = (mRays.size() + 255) & ~size_t(255);
  mMemory.assign(kColumns * count + 16, 0);
  const auto address = reinterpret_cast<uintptr_t>(mMemory.data());
  mFrom.resize(count);
  mStart = mMemory.data() + (64 - address % 64) % 64 / sizeof(float);
  mCount = count;
  for (size_t i = 0; i < count; ++i) {
    const Item &item = mRays[std::min(i, mRays.size() - 1)];
    const float values[kColumns] = {item.origin.x,    item.origin.y,    item.origin.z, item.direction.x,
                                    item.direction.y, item.direction.z, item.tMax};
    for (size_t c = 0; c < kColumns; ++c) column(c)[i] = values[c];
    mFrom[i] = item.from;
  }
  mRays = {};
}

RayBatch primaryRays(const Soup &soup, int width, int height) {
  const Vec3 forward = glm::normalize(soup.camera.at - soup.camera.eye);
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0))), up = glm::cross(right, forward);
  const float tangent = std::tan(glm::radians(soup.camera.degrees) / 2), wide = tangent * float(width) / float(height);
  RayBatch batch(size_t(width + 15) * size_t(height + 15));
  for (int tileY = 0; tileY < height; tileY += 16) {
    for (int tileX = 0; tileX < width; tileX += 16) {
      for (int i = 0; i < 256; ++i) {
        const int x = tileX + (i >> 4 & 3) * 4 + (i & 3), y = tileY + (i >> 6) * 4 + (i >> 2 & 3);
        const float u = ((float(x) + 0.5f) / float(width) * 2 - 1) * wide;
        const float v = (1 - (float(y) + 0.5f) / float(height) * 2) * tangent;
        batch.add(soup.camera.eye, glm::normalize(forward + right * u + up * v), kFar, kMiss);
      }
    }
  }
  batch.finish();
  return batch;
}

RayBatch secondaryRays(const Soup &soup, Kind kind, const RayBatch &primary, std::span<const FirstHit> hits) {
  RayBatch batch(hits.size());
  CosineLobe lobe;
  for (size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].primitive == kMiss) continue;
    const Vec3 *v = &soup.vertices[3 * size_t(hits[i].primitive)];
    Vec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    if (glm::dot(normal, normal) == 0) continue;
    const Vec3 d = primary.direction(i);
    normal = glm::normalize(normal);
    if (glm::dot(normal, d) > 0) normal = -normal;
    Vec3 point = primary.origin(i) + d * hits[i].t;
    point += normal * (1e-4f * (hits[i].t + 0.01f * maxComponent(glm::abs(point))));
    const Vec3 toLight = soup.light - point;
    // From behind it is the surface itself that keeps the light off.
    const uint32_t from = !asksBlocked(kind) || glm::dot(toLight, normal) > 0 ? hits[i].primitive : kMiss;
    if (kind == kShadow) batch.add(point, toLight, kToLight, from);
    if (kind == kFromLight) batch.add(soup.light, -toLight, kFromSurface, from);
    if (kind == kMirror) batch.add(point, d - normal * (2 * glm::dot(d, normal)), kFar, from);
    if (kind == kDiffuse) batch.add(point, lobe(normal), kFar, from);
  }
  batch.finish();
  return batch;
}

}  // namespace rc::bench
