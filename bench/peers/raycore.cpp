// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore.cpp: ourselves as one of those who are measured, below the API: the kernels of the cpu device.
#include "peers/tracer.h"
#include "rcddk/accel/builder.h"
#include "rchal/units/traversal.h"

namespace rc::bench {
namespace {

std::vector<hal::HotTriangle> trianglesOf(const Soup &soup) {
  std::vector<hal::HotTriangle> triangles;
  for (size_t i = 0; i < soup.vertices.size(); i += 3) {
    triangles.push_back({soup.vertices[i], soup.vertices[i + 1], soup.vertices[i + 2], 0, 0, 0});
  }
  return triangles;
}

class RaycoreTracer final : public Tracer {
 public:
  RaycoreTracer(const Soup &soup, AccelKind kind, const char *name, int threads)
      : mName(name), mTriangles(trianglesOf(soup)) {
    const Workers workers(threads);
    mAccel = ddk::buildAccel(kind, mTriangles, workers);
    mView.geometry[0] = {mTriangles, {}, {}, mAccel.view(), false};
  }

  std::string name() const override { return mName; }

  void trace(Kind kind, const RayBatch &rays, size_t begin, size_t end, FirstHit *hits) const override {
    for (size_t i = begin; i < end; ++i) {
      const hal::Ray ray{rays.origin(i), rays.direction(i)};
      if (kind == kShadow) {
        hits[i].primitive = hal::blockedByOpaque(mView, ray, rays.tMax(i)) ? 0 : kMiss;
      } else {
        const hal::Hit hit = hal::closestHit(mView, ray);
        hits[i] = {hit.t, hit.primitive};
      }
    }
  }

 private:
  std::string mName;
  std::vector<hal::HotTriangle> mTriangles;
  ddk::Accel mAccel;
  hal::SceneView mView;
};

class RaycoreBuilder final : public Builder {
 public:
  RaycoreBuilder(const Soup &soup, AccelKind kind, const char *name, int threads)
      : mSoup(soup), mTriangles(trianglesOf(soup)), mKind(kind), mName(name), mWorkers(threads) {}

  std::string name() const override { return mName; }
  void build() override {
    // The vertices are read where they moved: that is part of the work of a frame here.
    for (size_t i = 0; i < mTriangles.size(); ++i) {
      mTriangles[i].v0 = mSoup.vertices[3 * i];
      mTriangles[i].v1 = mSoup.vertices[3 * i + 1];
      mTriangles[i].v2 = mSoup.vertices[3 * i + 2];
    }
    mAccel = ddk::buildAccel(mKind, mTriangles, mWorkers);
  }

 private:
  const Soup &mSoup;
  std::vector<hal::HotTriangle> mTriangles;
  AccelKind mKind;
  std::string mName;
  Workers mWorkers;
  ddk::Accel mAccel;
};

}  // namespace

void addRaycore(const Soup &soup, int threads, Tracers &tracers) {
  tracers.push_back(std::make_unique<RaycoreTracer>(soup, AccelKind::KdTree, "raycore kdtree", threads));
  tracers.push_back(std::make_unique<RaycoreTracer>(soup, AccelKind::Bvh, "raycore bvh", threads));
}

void addRaycoreBuilders(const Soup &soup, int threads, Builders &builders) {
  builders.push_back(std::make_unique<RaycoreBuilder>(soup, AccelKind::KdTree, "raycore kdtree", threads));
  builders.push_back(std::make_unique<RaycoreBuilder>(soup, AccelKind::Bvh, "raycore bvh", threads));
}

}  // namespace rc::bench
