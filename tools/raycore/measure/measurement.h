// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// measurement.h: what tracing a model costs, asked of RayCore and of the clock.
// In: Show.  Out: Measurement, as JSON too.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "draw/show.h"

namespace rc::tool {

using Json = nlohmann::ordered_json;

inline constexpr double kMiB = 1 << 20;
inline constexpr std::array kRayKinds{"primary", "shadow", "reflected", "refracted", "straight"};

struct Measurement {
  double triangles = 0, skipped = 0;
  double submitMilliseconds = 0;  // draw calls and the structure of the static scene
  double staticBuildMilliseconds = 0, frameBuildMilliseconds = 0;
  double traceMilliseconds = 0, leastTraceMilliseconds = 0;  // median and least
  std::array<double, kRayKinds.size()> rays{};
  double triangleBytes = 0, structureBytes = 0, textureBytes = 0;
  double nodes = 0, leaves = 0, depth = 0, cost = 0;
  double boxesPerRay = 0, trianglesPerRay = 0;  // mean of the primary rays, each by itself
  // Millions of rays a second, shading included: primary ones alone, what shadows add to them, what reflection and
  // refraction add. Nothing: there are none, or their time is lost in the noise.
  std::optional<double> primaryRate, shadowRate, secondaryRate;
  uint64_t picture = 0;  // fingerprint

  double allRays() const;
  double raysPerSecond() const { return traceMilliseconds > 0 ? allRays() / traceMilliseconds * 1000 : 0; }
};

// Traces `repeat` pictures for each number.
Measurement measure(Show &show, int repeat);

Json jsonOf(const Measurement &measurement);

}  // namespace rc::tool
