// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "measure/measurement.h"

#include <RC/rc.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "measure/ray_cost.h"

namespace rc::tool {
namespace {

constexpr RCenum kKindTokens[] = {RC_FRAME_RAYS_PRIMARY, RC_FRAME_RAYS_SHADOW, RC_FRAME_RAYS_REFLECTED,
                                  RC_FRAME_RAYS_REFRACTED, RC_FRAME_RAYS_STRAIGHT};
static_assert(std::size(kKindTokens) == kRayKinds.size());

double valueOf(RCenum name) {
  RCfloat value = 0;
  rcGetFloatv(name, &value);
  return double(value);
}

// FNV-1a: equal pictures have equal ones.
uint64_t fingerprintOf(const Image &image) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const uint8_t byte : image.rgba) hash = (hash ^ byte) * 0x100000001b3;
  return hash;
}

struct Timed {
  double rays = 0, median = 0, least = 0;  // milliseconds
};

// Pictures of the scene that is there.
Timed traceAgain(Show &show, int repeat) {
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    show.picture(0);
    times.push_back(valueOf(RC_FRAME_TRACE_TIME));
  }
  std::sort(times.begin(), times.end());
  return {valueOf(RC_FRAME_RAYS), times[times.size() / 2], times[0]};
}

std::optional<double> rateOf(double rays, double milliseconds) {
  if (rays <= 0 || milliseconds <= 0) return std::nullopt;
  return rays / milliseconds / 1000;
}

// By what each kind adds to a picture without it.
void measureRates(Show &show, int repeat, const Timed &whole, Measurement &m) {
  rcDepthBounce(0);
  const Timed withShadows = traceAgain(show, repeat);
  rcDisable(RC_USE_SHADOW);
  const Timed primary = traceAgain(show, repeat);
  rcEnable(RC_USE_SHADOW);
  rcDepthBounce(RCuint(show.settings().bounces));
  m.primaryRate = rateOf(primary.rays, primary.median);
  m.shadowRate = rateOf(withShadows.rays - primary.rays, withShadows.median - primary.median);
  m.secondaryRate = rateOf(whole.rays - withShadows.rays, whole.median - withShadows.median);
}

void askAboutStructures(Measurement &m) {
  m.triangles = valueOf(RC_FRAME_TRIANGLES);
  m.skipped = valueOf(RC_FRAME_TRIANGLES_SKIPPED);
  m.staticBuildMilliseconds = valueOf(RC_STATIC_BUILD_TIME);
  m.frameBuildMilliseconds = valueOf(RC_FRAME_BUILD_TIME);
  m.triangleBytes = valueOf(RC_MEMORY_TRIANGLES);
  m.structureBytes = valueOf(RC_MEMORY_STRUCTURE);
  m.textureBytes = valueOf(RC_MEMORY_TEXTURES);
  m.nodes = valueOf(RC_STRUCTURE_NODES);
  m.leaves = valueOf(RC_STRUCTURE_LEAVES);
  m.depth = valueOf(RC_STRUCTURE_DEPTH);
  m.cost = valueOf(RC_STRUCTURE_COST);
}

int64_t whole(double value) { return static_cast<int64_t>(value); }

Json orNull(const std::optional<double> &value) { return value ? Json(*value) : Json(); }

}  // namespace

double Measurement::allRays() const { return std::accumulate(rays.begin(), rays.end(), 0.0); }

Measurement measure(Show &show, int repeat) {
  Measurement m;
  show.touch();
  m.picture = fingerprintOf(show.picture(0));
  m.submitMilliseconds = show.statistics().buildSeconds * 1000;
  askAboutStructures(m);
  const Timed whole = traceAgain(show, repeat);
  m.traceMilliseconds = whole.median;
  m.leastTraceMilliseconds = whole.least;
  for (size_t kind = 0; kind < kRayKinds.size(); ++kind) m.rays[kind] = valueOf(kKindTokens[kind]);
  measureRates(show, repeat, whole, m);
  const RayCosts costs = rayCosts(show);
  m.boxesPerRay = meanOf(costs.boxes);
  m.trianglesPerRay = meanOf(costs.triangles);
  checkErrors("measuring");
  return m;
}

Json jsonOf(const Measurement &m) {
  Json rays;
  for (size_t kind = 0; kind < kRayKinds.size(); ++kind) rays[kRayKinds[kind]] = whole(m.rays[kind]);
  return {{"triangles", whole(m.triangles)},
          {"triangles_skipped", whole(m.skipped)},
          {"submit_ms", m.submitMilliseconds},
          {"static_build_ms", m.staticBuildMilliseconds},
          {"frame_build_ms", m.frameBuildMilliseconds},
          {"trace_ms", m.traceMilliseconds},
          {"trace_ms_least", m.leastTraceMilliseconds},
          {"rays", whole(m.allRays())},
          {"rays_by_kind", rays},
          {"mrays_per_s", m.raysPerSecond() / 1e6},
          {"mrays_per_s_primary", orNull(m.primaryRate)},
          {"mrays_per_s_shadow", orNull(m.shadowRate)},
          {"mrays_per_s_secondary", orNull(m.secondaryRate)},
          {"memory_bytes",
           {{"triangles", whole(m.triangleBytes)},
            {"structure", whole(m.structureBytes)},
            {"textures", whole(m.textureBytes)}}},
          {"structure",
           {{"nodes", whole(m.nodes)}, {"leaves", whole(m.leaves)}, {"depth", whole(m.depth)}, {"cost", m.cost}}},
          {"boxes_per_ray", m.boxesPerRay},
          {"triangles_per_ray", m.trianglesPerRay},
          {"picture", fmt::format("{:016x}", m.picture)}};
}

}  // namespace rc::tool
