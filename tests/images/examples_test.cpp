// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Every example, as a user runs it: it ends by itself in test mode, draws what it should, and draws it the same on
// any number of threads, with every structure and on every device.
#include <gtest/gtest.h>

#include <set>

#include "images/run_example.h"

namespace rc::test {
namespace {

struct Example {
  const char *name;
  double leastCovered;  // share of pixels that differ from the clear colour, which lies in a corner of the picture
  size_t leastColours;
};

const Example kExamples[] = {
    {"02_5a_perspective", 0.05, 2},
    {"02_5b_frustum", 0.02, 2},
    {"02_5c_look_at", 0.05, 2},
    {"03_2a_translate", 0.05, 2},
    {"03_2b_rotate", 0.05, 2},
    {"03_2c_scale", 0.15, 2},
    {"03_2d_rotate_then_translate", 0.05, 2},
    {"03_2e_translate_then_rotate", 0.05, 2},
    {"04_2_lights", 0.5, 5000},
    {"05_5_textures", 0.6, 5000},
    {"06_5a_phong", 0.2, 500},
    {"06_5b_reflection", 0.03, 500},
    {"06_5c_refraction", 0.1, 200},
    {"09_4_cornell_box", 0.5, 300},
    {"b_cube", 0.02, 20},
    {"c_earth", 0.9, 5000},
    {"d_1_5_egl", 0.05, 3},
};

void PrintTo(const Example &example, std::ostream *out) { *out << example.name; }

class ExampleTest : public testing::TestWithParam<Example> {};

// Plain EGL programs know no test mode: RAYCORE_FRAMES ends them.
constexpr int kFrames = 3;

TEST_P(ExampleTest, DrawsHeadlessAndEnds) {
  const ExampleRun run = runExample(GetParam().name, kFrames, "RAYCORE_TEST=1 RAYCORE_LOG=error");
  ASSERT_EQ(run.exitCode, 0) << run.output;
  EXPECT_EQ(run.output.find("RC_INVALID"), std::string::npos) << run.output;
  ASSERT_EQ(run.picture.width, 800);
  ASSERT_EQ(run.picture.height, 480);
  std::set<Pixel> colours;
  size_t covered = 0;
  const Pixel corner = run.picture.at(799, 0);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 800; ++x) {
      const Pixel pixel = run.picture.at(x, y);
      colours.insert(pixel);
      covered += pixel != corner;
    }
  }
  EXPECT_GE(double(covered) / (800 * 480), GetParam().leastCovered);
  EXPECT_GE(colours.size(), GetParam().leastColours);
}

TEST_P(ExampleTest, IsTheSameByteForByteOnAnyNumberOfThreads) {
  const ExampleRun one = runExample(GetParam().name, kFrames, "RAYCORE_THREADS=1");
  ASSERT_FALSE(one.picture.empty()) << one.output;
  for (const char *threads : {"RAYCORE_THREADS=2", "RAYCORE_THREADS=7"}) {
    EXPECT_EQ(one.picture.rgb, runExample(GetParam().name, kFrames, threads).picture.rgb) << threads;
  }
}

// The largest difference of a channel.
int difference(const Picture &a, const Picture &b) {
  if (a.rgb.size() != b.rgb.size() || a.empty()) return 256;
  int largest = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(int(a.rgb[i]) - int(b.rgb[i])));
  return largest;
}

TEST_P(ExampleTest, IsTheSameWithEveryStructure) {
  const ExampleRun kdTree = runExample(GetParam().name, kFrames, "RAYCORE_ACCEL=kdtree");
  EXPECT_LE(difference(kdTree.picture, runExample(GetParam().name, kFrames, "RAYCORE_ACCEL=bvh").picture), 1);
}

// Small, since ref tries every triangle for every ray; programs without the framework have one size.
TEST_P(ExampleTest, IsTheSameOnRefAndCpu) {
  if (std::string(GetParam().name) == "d_1_5_egl") GTEST_SKIP() << "its size cannot be chosen";
  const char *size = "small 96 48";
  const ExampleRun ref = runExample(GetParam().name, 1, "RAYCORE_DEVICE=ref", size);
  const ExampleRun cpu = runExample(GetParam().name, 1, "RAYCORE_DEVICE=cpu", size);
  ASSERT_EQ(ref.picture.width, 96) << ref.output;
  EXPECT_LE(difference(ref.picture, cpu.picture), 1);
}

std::string nameOf(const testing::TestParamInfo<Example> &info) { return "Example_" + std::string(info.param.name); }

INSTANTIATE_TEST_SUITE_P(Guide, ExampleTest, testing::ValuesIn(kExamples), nameOf);

TEST(ExampleEnvironment, ACaptureFolderThatDoesNotExistIsReportedAndTheProgramGoesOn) {
  const ExampleRun run = runExample("02_5a_perspective", 2, "RAYCORE_CAPTURE=no/such/folder/a.png RAYCORE_LOG=frame");
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.output.find("cannot write \"no/such/folder/a.png\": No such file or directory"), std::string::npos)
      << run.output;
}

TEST(ExampleEnvironment, NonsenseIsReported) {
  const ExampleRun run = runExample("02_5a_perspective", 1, "RAYCORE_DEVICE=fpga RAYCORE_THREADS=x");
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.output.find("RAYCORE_DEVICE=fpga is ignored"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("RAYCORE_THREADS=x is ignored"), std::string::npos) << run.output;
  EXPECT_FALSE(run.picture.empty());
}

TEST(ExampleEnvironment, TestModeEndsAfterThreeFrames) {
  const ExampleRun run = runExample("06_5b_reflection", 100, "RAYCORE_TEST=1 RAYCORE_LOG=frame");
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.output.find("frame 3:"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("frame 4:"), std::string::npos) << run.output;
}

TEST(ExampleEnvironment, SamplesSmoothEdges) {
  const ExampleRun plain = runExample("02_5a_perspective", 1),
                   smooth = runExample("02_5a_perspective", 1, "RAYCORE_SAMPLES=16");
  std::set<Pixel> few, many;
  for (int x = 0; x < 800; ++x) few.insert(plain.picture.at(x, 300)), many.insert(smooth.picture.at(x, 300));
  EXPECT_EQ(few.size(), 2u);
  EXPECT_GT(many.size(), 2u);
}

}  // namespace
}  // namespace rc::test
