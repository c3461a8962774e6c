// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore.cpp: ourselves as one of those who are measured, below the API: the kernels of the cpu device.
#include "peers/raycore.h"

#include "base/instruction_set.h"
#include "base/settings.h"
#include "peers/tracer.h"
#include "rcddi/cpu/trace.h"
#include "rcddk/accel/builder.h"
#include "rchal/queues.h"

namespace rc::bench {

std::vector<hal::HotTriangle> trianglesOf(const Soup &soup) {
  std::vector<hal::HotTriangle> triangles;
  for (size_t i = 0; i < soup.vertices.size(); i += 3) {
    triangles.push_back({soup.vertices[i], soup.vertices[i + 1], soup.vertices[i + 2], 0, 0, 0});
  }
  return triangles;
}

namespace {

class RaycoreTracer final : public Tracer {
 public:
  RaycoreTracer(const Soup &soup, AccelKind kind, ddk::Lifetime lifetime, const char *name, int threads)
      : mName(name), mTriangles(trianglesOf(soup)) {
    const Workers workers(threads);
    mAccel = ddk::buildAccel(kind, mTriangles, workers, lifetime);
    mView.geometry[0] = {mTriangles, {}, {}, mAccel.view(), false};
  }

  std::string name() const override { return mName; }

  void trace(Kind kind, const RayBatch &rays, size_t begin, size_t end, FirstHit *hits) const override {
    ddi::cpu::RayStream stream{{rays.column(0) + begin, rays.column(1) + begin, rays.column(2) + begin},
                               {rays.column(3) + begin, rays.column(4) + begin, rays.column(5) + begin},
                               end - begin,
                               asksBlocked(kind) ? rays.from() + begin : nullptr};
    stream.common = haveOneOrigin(kind);
    if (asksBlocked(kind)) {
      stream.reach.end = rays.tMax(begin);  // one for all rays of a kind
      uint8_t blocked[kMost];
      ddi::cpu::findBlocked(mView, stream, blocked, nullptr);
      for (size_t i = begin; i < end; ++i) hits[i].primitive = blocked[i - begin] ? 0 : kMiss;
    } else {
      thread_local hal::HitQueue found;
      ddi::cpu::closestHits(mView, stream, found);
      for (size_t i = begin; i < end; ++i) hits[i] = {found.t[i - begin], found.primitive[i - begin]};
    }
  }

 private:
  static constexpr size_t kMost = 1024;  // rays of a call

  std::string mName;
  std::vector<hal::HotTriangle> mTriangles;
  ddk::Accel mAccel;
  hal::SceneView mView;
};

class RaycoreBuilder : public Builder {
 public:
  RaycoreBuilder(const Soup &soup, AccelKind kind, ddk::Lifetime lifetime, const char *name, const char *task,
                 int threads)
      : mSoup(soup),
        mTriangles(trianglesOf(soup)),
        mKind(kind),
        mLifetime(lifetime),
        mName(name),
        mTask(task),
        mWorkers(threads) {}

  std::string name() const override { return mName; }
  std::string task() const override { return mTask; }
  void build() override {
    readVertices();
    mAccel = ddk::buildAccel(mKind, mTriangles, mWorkers, mLifetime, std::move(mAccel));
  }

 protected:
  // The vertices are read where they moved: that is part of the work of a frame here.
  void readVertices() {
    forEachShare(mWorkers, mTriangles.size(), 4096, [&](size_t, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        mTriangles[i].v0 = mSoup.vertices[3 * i];
        mTriangles[i].v1 = mSoup.vertices[3 * i + 1];
        mTriangles[i].v2 = mSoup.vertices[3 * i + 2];
      }
    });
  }

  const Soup &mSoup;
  std::vector<hal::HotTriangle> mTriangles;
  AccelKind mKind;
  ddk::Lifetime mLifetime;
  std::string mName, mTask;
  Workers mWorkers;
  ddk::Accel mAccel;
};

class RaycoreRefit final : public RaycoreBuilder {
 public:
  RaycoreRefit(const Soup &soup, int threads)
      : RaycoreBuilder(soup, AccelKind::Bvh, ddk::Lifetime::Frame, "raycore bvh refit", "refit", threads) {
    RaycoreBuilder::build();
  }
  void build() override {
    readVertices();
    ddk::refit(mTriangles, mWorkers, mAccel);
  }
};

}  // namespace

void addRaycore(const Soup &soup, int threads, const std::vector<std::string> &who, Tracers &tracers) {
  limitInstructionSet(settings().instructionSet);
  const auto add = [&](AccelKind kind, ddk::Lifetime lifetime, const char *name) {
    if (!isWanted(name, who)) return;
    tracers.push_back(std::make_unique<RaycoreTracer>(soup, kind, lifetime, name, threads));
  };
  add(AccelKind::Bvh, ddk::Lifetime::Scene, "raycore bvh");
  add(AccelKind::Bvh, ddk::Lifetime::Frame, "raycore bvh of a frame");
  add(AccelKind::KdTree, ddk::Lifetime::Scene, "raycore kdtree");
}

void addRaycoreBuilders(const Soup &soup, int threads, Builders &builders) {
  const auto add = [&](AccelKind kind, ddk::Lifetime lifetime, const char *name, const char *task) {
    builders.push_back(std::make_unique<RaycoreBuilder>(soup, kind, lifetime, name, task, threads));
  };
  add(AccelKind::KdTree, ddk::Lifetime::Scene, "raycore kdtree", "build");
  add(AccelKind::Bvh, ddk::Lifetime::Scene, "raycore bvh", "build");
  add(AccelKind::Bvh, ddk::Lifetime::Frame, "raycore bvh of a frame", "rebuild");
  builders.push_back(std::make_unique<RaycoreRefit>(soup, threads));
}

}  // namespace rc::bench
