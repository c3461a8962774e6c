// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// embree.cpp: the distribution's Embree 3 as a peer: single rays and packets of 16 on its HIGH and MEDIUM trees.
#include <embree3/rtcore.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "peers/tracer.h"

namespace rc::bench {
namespace {

constexpr size_t kWide = 16;

struct Quality {
  const char *name;
  RTCBuildQuality scene, geometry;
  RTCSceneFlags flags;
  const char *task;
};
constexpr Quality kHigh{"high", RTC_BUILD_QUALITY_HIGH, RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_NONE, "build"};
constexpr Quality kMedium{"medium", RTC_BUILD_QUALITY_MEDIUM, RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_NONE, "build"};
constexpr Quality kLow{"low", RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_LOW, RTC_SCENE_FLAG_DYNAMIC, "rebuild"};
constexpr Quality kRefit{"refit", RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_REFIT, RTC_SCENE_FLAG_DYNAMIC, "refit"};

// Embree keeps to the instruction set that we are told to keep to.
std::string configuration(int threads) {
  struct Row {
    const char *ours, *theirs;
  };
  constexpr Row kRows[] = {{"sse4", "sse4.2"}, {"avx2", "avx2"}, {"avx512", "avx512"}};
  std::string text = "threads=" + std::to_string(threads);
  const char *wanted = std::getenv("RAYCORE_INSTRUCTION_SET");
  for (const Row &row : kRows) {
    if (wanted && !std::strcmp(wanted, row.ours)) text += std::string(",isa=") + row.theirs;
  }
  return text;
}

// A scene of one mesh, with its buffers.
class Mesh {
 public:
  Mesh(const Soup &soup, const Quality &quality, int threads) : mSoup(soup) {
    mDevice = rtcNewDevice(configuration(threads).c_str());
    mScene = rtcNewScene(mDevice);
    rtcSetSceneFlags(mScene, quality.flags);
    rtcSetSceneBuildQuality(mScene, quality.scene);
    mGeometry = rtcNewGeometry(mDevice, RTC_GEOMETRY_TYPE_TRIANGLE);
    mVertices = static_cast<Vec3 *>(rtcSetNewGeometryBuffer(mGeometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                            sizeof(Vec3), soup.vertices.size()));
    auto *indices = static_cast<uint32_t *>(
        rtcSetNewGeometryBuffer(mGeometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, soup.triangles()));
    for (size_t i = 0; i < soup.vertices.size(); ++i) indices[i] = uint32_t(i);
    rtcSetGeometryBuildQuality(mGeometry, quality.geometry);
    rtcAttachGeometry(mScene, mGeometry);
    commit();
  }
  ~Mesh() {
    rtcReleaseGeometry(mGeometry);
    rtcReleaseScene(mScene);
    rtcReleaseDevice(mDevice);
  }
  Mesh(const Mesh &) = delete;
  Mesh &operator=(const Mesh &) = delete;

  void commit() {
    std::memcpy(mVertices, mSoup.vertices.data(), mSoup.vertices.size() * sizeof(Vec3));
    rtcUpdateGeometryBuffer(mGeometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(mGeometry);
    rtcCommitScene(mScene);
  }
  RTCScene scene() const { return mScene; }

 private:
  const Soup &mSoup;
  RTCDevice mDevice;
  RTCScene mScene;
  RTCGeometry mGeometry;
  Vec3 *mVertices;
};

RTCIntersectContext contextOf(bool coherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

class Single final : public Tracer {
 public:
  Single(std::shared_ptr<Mesh> mesh, const char *quality) : mMesh(std::move(mesh)), mQuality(quality) {}

  std::string name() const override { return std::string("embree ") + mQuality + " single"; }

  void trace(Kind kind, const RayBatch &rays, size_t begin, size_t end, FirstHit *hits) const override {
    RTCIntersectContext context = contextOf(kind == kPrimary || asksBlocked(kind));
    for (size_t i = begin; i < end; ++i) {
      RTCRayHit query;
      const Vec3 o = rays.origin(i), d = rays.direction(i);
      query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, rays.tMax(i), ~0u, 0, 0};
      query.hit.geomID = query.hit.primID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      if (asksBlocked(kind)) {
        rtcOccluded1(mMesh->scene(), &context, &query.ray);
        hits[i].primitive = query.ray.tfar < 0 ? 0 : kMiss;
      } else {
        rtcIntersect1(mMesh->scene(), &context, &query);
        hits[i] = {query.ray.tfar, query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kMiss : query.hit.primID};
      }
    }
  }

 private:
  std::shared_ptr<Mesh> mMesh;
  const char *mQuality;
};

class Packets final : public Tracer {
 public:
  Packets(std::shared_ptr<Mesh> mesh, const char *quality) : mMesh(std::move(mesh)), mQuality(quality) {}

  std::string name() const override { return std::string("embree ") + mQuality + " packet-16"; }

  void trace(Kind kind, const RayBatch &rays, size_t begin, size_t end, FirstHit *hits) const override {
    RTCIntersectContext context = contextOf(true);
    alignas(64) int valid[kWide];
    std::memset(valid, 0xff, sizeof valid);
    for (size_t i = begin; i < end; i += kWide) {
      alignas(64) RTCRayHit16 query;
      fill(query.ray, rays, i);
      if (asksBlocked(kind)) {
        rtcOccluded16(valid, mMesh->scene(), &context, &query.ray);
        for (size_t k = 0; k < kWide; ++k) hits[i + k].primitive = query.ray.tfar[k] < 0 ? 0 : kMiss;
        continue;
      }
      for (auto *ids : {query.hit.geomID, query.hit.primID, query.hit.instID[0]}) std::memset(ids, 0xff, 4 * kWide);
      rtcIntersect16(valid, mMesh->scene(), &context, &query);
      for (size_t k = 0; k < kWide; ++k) hits[i + k] = {query.ray.tfar[k], query.hit.primID[k]};
    }
  }

 private:
  static void fill(RTCRay16 &ray, const RayBatch &rays, size_t i) {
    float *columns[] = {ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z, ray.tfar};
    for (size_t c = 0; c < RayBatch::kColumns; ++c) std::memcpy(columns[c], rays.column(c) + i, 4 * kWide);
    std::memset(ray.tnear, 0, sizeof ray.tnear);
    std::memset(ray.time, 0, sizeof ray.time);
    std::memset(ray.mask, 0xff, sizeof ray.mask);
    std::memset(ray.flags, 0, sizeof ray.flags);
  }

  std::shared_ptr<Mesh> mMesh;
  const char *mQuality;
};

class EmbreeBuilder final : public Builder {
 public:
  EmbreeBuilder(const Soup &soup, const Quality &quality, int threads)
      : mMesh(soup, quality, threads), mQuality(quality.name), mTask(quality.task) {}

  std::string name() const override { return std::string("embree ") + mQuality; }
  std::string task() const override { return mTask; }
  void build() override { mMesh.commit(); }

 private:
  Mesh mMesh;
  const char *mQuality, *mTask;
};

}  // namespace

void addEmbree(const Soup &soup, int threads, const std::vector<std::string> &who, Tracers &tracers) {
  for (const Quality &quality : {kHigh, kMedium}) {
    if (!isWanted(std::string("embree ") + quality.name, who)) continue;
    const auto mesh = std::make_shared<Mesh>(soup, quality, threads);
    tracers.push_back(std::make_unique<Single>(mesh, quality.name));
    tracers.push_back(std::make_unique<Packets>(mesh, quality.name));
  }
}

void addEmbreeBuilders(const Soup &soup, int threads, Builders &builders) {
  for (const Quality &quality : {kHigh, kMedium, kLow, kRefit}) {
    builders.push_back(std::make_unique<EmbreeBuilder>(soup, quality, threads));
  }
}

}  // namespace rc::bench
