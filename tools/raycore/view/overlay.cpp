// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/overlay.h"

#include <RC/rc.h>
#include <fmt/format.h>

#include <algorithm>

#include "output/text.h"

namespace rc::tool {
namespace {

constexpr int kPlace = 8;

double valueOf(RCenum name) {
  RCfloat value = 0;
  rcGetFloatv(name, &value);
  return double(value);
}

}  // namespace

void MotionMeter::frame(double seconds) {
  ++mFrames;
  mSum += seconds;
  mSlowest = std::max(mSlowest, seconds);
  mRecent = mRecent == 0 ? seconds : 0.8 * mRecent + 0.2 * seconds;
}

std::string MotionMeter::summary() const {
  if (mFrames == 0) return {};
  return fmt::format("moving: {} frames, {:.1f} a second, the slowest took {:.0f} ms", mFrames, mFrames / mSum,
                     mSlowest * 1000);
}

std::vector<std::string> statisticsLines(const Show &show, const Refinement &refinement, const Playback &playback,
                                         const MotionMeter &motion) {
  const double rays = valueOf(RC_FRAME_RAYS), milliseconds = valueOf(RC_FRAME_TRACE_TIME);
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{:.0f} triangles, {:.0f} skipped; {:.1f} MiB, structure {:.1f}, textures {:.1f}",
                              valueOf(RC_FRAME_TRIANGLES), valueOf(RC_FRAME_TRIANGLES_SKIPPED),
                              valueOf(RC_MEMORY_TRIANGLES) / 0x1p20, valueOf(RC_MEMORY_STRUCTURE) / 0x1p20,
                              valueOf(RC_MEMORY_TEXTURES) / 0x1p20));
  lines.push_back(fmt::format("structure: {:.0f} nodes, {:.0f} leaves, depth {:.0f}, cost {:.1f}, built in {:.1f} ms",
                              valueOf(RC_STRUCTURE_NODES), valueOf(RC_STRUCTURE_LEAVES), valueOf(RC_STRUCTURE_DEPTH),
                              valueOf(RC_STRUCTURE_COST), valueOf(RC_STATIC_BUILD_TIME)));
  lines.push_back(fmt::format("last pass: {:.0f} rays in {:.1f} ms, {:.2f} Mrays/s", rays, milliseconds,
                              milliseconds > 0 ? rays / milliseconds / 1000 : 0));
  lines.push_back(fmt::format("  {:.0f} primary, {:.0f} shadow, {:.0f} reflected, {:.0f} refracted, {:.0f} straight on",
                              valueOf(RC_FRAME_RAYS_PRIMARY), valueOf(RC_FRAME_RAYS_SHADOW),
                              valueOf(RC_FRAME_RAYS_REFLECTED), valueOf(RC_FRAME_RAYS_REFRACTED),
                              valueOf(RC_FRAME_RAYS_STRAIGHT)));
  lines.push_back(fmt::format("in motion: {:.1f} frames/s, one pixel for {} x {}", motion.perSecond(),
                              refinement.step(), refinement.step()));
  lines.push_back(fmt::format("at rest: {} of {} samples", refinement.samplesDone(), refinement.samples()));
  if (show.animation() >= 0) {
    const std::string &name = show.scene().animations[size_t(show.animation())].name;
    lines.push_back(fmt::format("animation {}: {:.2f} of {:.2f} s{}", name.empty() ? "(no name)" : name,
                                playback.seconds(), playback.duration(), playback.playing() ? ", playing" : ""));
  }
  return lines;
}

void drawOverlay(Image &image, const std::vector<std::string> &panel, const std::string &message) {
  drawPanel(image, kPlace, kPlace, panel);
  if (message.empty()) return;
  drawPanel(image, kPlace, image.height - kPlace - panelSize({message})[1], {message});
}

}  // namespace rc::tool
