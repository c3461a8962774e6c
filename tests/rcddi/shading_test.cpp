// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Pictures of the cpu device, on every instruction set and any number of threads, against those of the ref device.
#include <gtest/gtest.h>

#include "common/on_each_target.h"
#include "rcddi/random_scenes.h"
#include "rcddk/brightness.h"
#include "rchal/framebuffer.h"

namespace rc::test {
namespace {

using namespace rc::hal;

constexpr int kWidth = 40, kHeight = 28;  // neither is a multiple of a tile

struct Picture {
  std::vector<uint32_t> pixels = std::vector<uint32_t>(size_t(kWidth) * kHeight);
  RayCounts counts;
};

Picture render(const char *device, int threads, SceneView view, bool rgb565 = false) {
  view.camera.columns = kWidth;
  view.camera.rows = kHeight;
  Picture picture;
  picture.counts = createDevice(device, threads)->trace(view, {picture.pixels.data(), kWidth, kHeight, rgb565});
  return picture;
}

int largestDifference(const Picture &a, const Picture &b) {
  int largest = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    for (int shift = 0; shift < 32; shift += 8) {
      largest = std::max(largest, std::abs(int(a.pixels[i] >> shift & 255) - int(b.pixels[i] >> shift & 255)));
    }
  }
  return largest;
}

double meanDifference(const Picture &a, const Picture &b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    for (int shift = 0; shift < 24; shift += 8) {
      sum += std::abs(int(a.pixels[i] >> shift & 255) - int(b.pixels[i] >> shift & 255));
    }
  }
  return sum / double(3 * a.pixels.size());
}

class Shading : public testing::TestWithParam<uint32_t> {};
class FewerRays : public testing::TestWithParam<uint32_t> {};

TEST_P(Shading, CpuAgreesWithRefOnEachInstructionSet) {
  const RandomScene scene(GetParam());
  const Picture truth = render("ref", 1, scene.view());
  onEachTarget([&] {
    const Picture found = render("cpu", 1, scene.view());
    EXPECT_LE(largestDifference(found, truth), 1);
    EXPECT_EQ(found.counts.all(), truth.counts.all());
    EXPECT_EQ(found.counts.shadow, truth.counts.shadow);
    EXPECT_EQ(found.counts.primaryHits, truth.counts.primaryHits);
  });
}

TEST_P(Shading, ThreadsDoNotChangeABit) {
  const RandomScene scene(GetParam());
  const Picture one = render("cpu", 1, scene.view());
  for (const int threads : {2, 5}) EXPECT_EQ(render("cpu", threads, scene.view()).pixels, one.pixels);
}

// Shadow rays may start at lights or at surfaces: hardly any of them says something else for it.
TEST_P(FewerRays, WhereShadowRaysStartIsNotSeen) {
  const RandomScene scene(GetParam());
  SceneView view = scene.view();
  std::vector<LightRow> lights(view.lights.begin(), view.lights.end());
  view.lights = lights;
  Picture pictures[2];
  for (const bool fromLights : {false, true}) {
    for (LightRow &light : lights) light.sendsShadowRays = !light.directional && fromLights;
    pictures[fromLights] = render("cpu", 1, view);
  }
  EXPECT_EQ(pictures[0].counts.shadow, pictures[1].counts.shadow);
  EXPECT_LE(meanDifference(pictures[0], pictures[1]), 0.05);
}

TEST(Pixels, OfFiveSixAndFiveBitsAreThoseOfEightRounded) {
  const RandomScene scene(3);
  SceneView view = scene.view();
  view.scissor = PixelRect{3, 2, 30, 20};
  view.writeMask = 0xff00ffffu;
  onEachTarget([&] {
    for (const char *device : {"ref", "cpu"}) {
      std::vector<uint32_t> rounded = render(device, 1, view).pixels;
      for (uint32_t &pixel : rounded) pixel = roundTo565(pixel);
      EXPECT_EQ(render(device, 1, view, true).pixels, rounded) << device;
    }
  });
}

// Tiles of whole blocks of pixels take a way of their own.
TEST(Pixels, OfTilesOfAnySizeAreWhereTheyBelong) {
  const RandomScene scene(4);
  SceneView view = scene.view();
  for (const PixelRect &part : {PixelRect{0, 0, 40, 28}, PixelRect{3, 1, 32, 16}, PixelRect{0, 0, 39, 28},
                                PixelRect{1, 0, 36, 27}, PixelRect{7, 5, 4, 4}, PixelRect{7, 5, 3, 2}}) {
    view.scissor = part;
    for (const uint32_t mask : {~0u, 0xff00ffffu}) {
      view.writeMask = mask;
      const Picture truth = render("ref", 1, view);
      onEachTarget([&] { EXPECT_LE(largestDifference(render("cpu", 1, view), truth), 1); });
    }
  }
}

// The corners of a tile whose sides are one less than a multiple of a block come in whole blocks, its pixels do not.
// What they look like says which pixels get more samples, alike on each instruction set.
TEST(Pixels, OfWhichTheCornersComeInWholeBlocks) {
  const RandomScene scene(20);
  SceneView view = scene.view();
  view.samples = 4;
  view.adaptive = true;
  for (const PixelRect &part : {PixelRect{0, 0, 39, 27}, PixelRect{12, 8, 7, 11}, PixelRect{16, 12, 3, 3}}) {
    view.scissor = part;
    const Picture truth = render("ref", 1, view), best = render("cpu", 1, view);
    onEachTarget([&] {
      const Picture found = render("cpu", 1, view);
      EXPECT_LE(largestDifference(found, truth), 1);
      EXPECT_EQ(found.counts.primary, best.counts.primary);
    });
  }
}

// The same choice of pixels on every device, and hardly another picture than with all samples everywhere.
TEST_P(FewerRays, AdaptiveSamplesAreWhereTheyAreSeen) {
  const RandomScene scene(GetParam());
  SceneView view = scene.view();
  view.samples = 4;
  const Picture everywhere = render("cpu", 1, view);
  view.adaptive = true;
  const Picture adaptive = render("cpu", 1, view);
  EXPECT_LE(largestDifference(adaptive, render("ref", 1, view)), 1);
  EXPECT_LE(meanDifference(adaptive, everywhere), 1);
  EXPECT_LT(adaptive.counts.primary, everywhere.counts.primary + size_t(kWidth + 3) * (kHeight + 2));
}

TEST_P(FewerRays, RaysThatAreLeftOutAreNotMissed) {
  const RandomScene scene(GetParam());
  SceneView view = scene.view();
  view.maxBounces = 9;
  view.minWeight = 0;
  view.ignorable = 0;
  const Picture all = render("cpu", 1, view);
  view.ignorable = ddk::ignorable(view);
  const Picture fewer = render("cpu", 1, view);
  EXPECT_LE(largestDifference(all, fewer), 1);
  EXPECT_LE(fewer.counts.all(), all.counts.all());
  EXPECT_LE(largestDifference(fewer, render("ref", 1, view)), 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Shading, testing::Range(uint32_t{1}, uint32_t{41}));
INSTANTIATE_TEST_SUITE_P(Scenes, FewerRays, testing::Range(uint32_t{20}, uint32_t{30}));

}  // namespace
}  // namespace rc::test
