// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/frame_stats.h"

#include <cmath>
#include <cstdio>

namespace rc::ddk {
namespace {

std::string count(uint64_t number) { return std::to_string(number); }

// " (3 degenerate, 1 not finite)", or nothing where nothing was skipped.
std::string reasons(const SkippedTriangles &skipped) {
  const struct {
    size_t number;
    const char *reason;
  } rows[] = {
      {skipped.degenerate, " degenerate"}, {skipped.notFinite, " not finite"}, {skipped.noData, " without data"}};
  std::string text;
  for (const auto &row : rows) {
    if (row.number > 0) text += (text.empty() ? " (" : ", ") + count(row.number) + row.reason;
  }
  return text.empty() ? text : text + ")";
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", value);
  return text;
}

// Of the workers' time; nothing where it was not measured.
std::string shares(const hal::UnitTimes &times) {
  if (times.all() <= 0) return "";
  const struct {
    double seconds;
    const char *unit;
  } rows[] = {{times.primary, "primary"}, {times.secondary, "secondary"}, {times.shadow, "shadow"},
              {times.shade, "shade"},     {times.generate, "generate"},   {times.store, "store"}};
  std::string text;
  for (const auto &row : rows) {
    text += (text.empty() ? " (" : ", ") + std::string(row.unit) + " " +
            count(uint64_t(std::llround(100 * row.seconds / times.all()))) + " %";
  }
  return text + ")";
}

}  // namespace

std::string describe(const FrameStats &f) {
  std::string text = count(uint64_t(f.width)) + " x " + count(uint64_t(f.height)) + ", ";
  text += count(f.staticTriangles + f.dynamicTriangles) + " triangles (" + count(f.staticTriangles) + " static, " +
          count(f.dynamicTriangles) + " dynamic), " + count(f.skipped.all()) + " skipped" + reasons(f.skipped);
  if (f.emptyDraws > 0) text += ", " + count(f.emptyDraws) + " draw calls without vertices";
  if (f.skipped.clipped > 0) text += ", " + count(f.skipped.clipped) + " behind clip planes";
  text += f.defaultLight ? ", no light on: the default one" : ", " + count(f.lights) + " lights on";
  text += ", " + count(f.rays.all()) + " rays (" + count(f.rays.primary) + " primary, of which " +
          count(f.rays.primaryHits) + " met something, " + count(f.rays.shadow) + " shadow, " +
          count(f.rays.reflected) + " reflected, " + count(f.rays.refracted) + " refracted, " + count(f.rays.straight) +
          " straight on)";
  text += ", transform " + milliseconds(f.transformMilliseconds) + ", build " + milliseconds(f.buildMilliseconds) +
          ", trace " + milliseconds(f.traceMilliseconds) + shares(f.rays.times);
  if (f.presentMilliseconds > 0) text += ", present (frame before) " + milliseconds(f.presentMilliseconds);
  return text;
}

}  // namespace rc::ddk
