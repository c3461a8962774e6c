// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The environment: defaults, every value, every complaint.
#include "base/settings.h"

#include <gtest/gtest.h>

#include <map>

namespace rc::test {
namespace {

std::map<std::string, std::string> sVariables;

Settings read(std::string &report) {
  return readSettings(
      [](const char *name) -> const char * {
        const auto found = sVariables.find(name);
        return found == sVariables.end() ? nullptr : found->second.c_str();
      },
      report);
}

TEST(Settings, Defaults) {
  sVariables.clear();
  std::string report;
  EXPECT_EQ(read(report), Settings{});
  EXPECT_EQ(report, "");
}

TEST(Settings, EveryVariable) {
  sVariables = {{"RAYCORE_DEVICE", "ref"},           {"RAYCORE_THREADS", "3"},         {"RAYCORE_ACCEL", "bvh"},
                {"RAYCORE_PROFILE", "1000"},         {"RAYCORE_SAMPLES", "4"},         {"RAYCORE_FRAMES", "7"},
                {"RAYCORE_CAPTURE", "a.png"},        {"RAYCORE_LOG", "frame"},         {"RAYCORE_TEST", "1"},
                {"RAYCORE_INSTRUCTION_SET", "avx2"}, {"RAYCORE_MEMORY_LIMIT", "512M"}, {"RAYCORE_PIPELINE", "0"}};
  std::string report;
  const Settings s = read(report);
  EXPECT_EQ(report, "");
  EXPECT_EQ(s.device, "ref");
  EXPECT_EQ(s.threads, 3);
  EXPECT_EQ(s.accel, AccelKind::Bvh);
  EXPECT_EQ(s.profile, "1000");
  EXPECT_EQ(s.samples, 4);
  EXPECT_EQ(s.frames, 7);
  EXPECT_EQ(s.capture, "a.png");
  EXPECT_EQ(s.log, LogLevel::Frame);
  EXPECT_TRUE(s.test);
  EXPECT_EQ(s.instructionSet, "avx2");
  EXPECT_EQ(s.memoryLimit, uint64_t(512) << 20);
  EXPECT_FALSE(s.pipeline);
}

TEST(Settings, NonsenseIsReportedAndIgnored) {
  for (const auto &[name, value] : std::map<std::string, std::string>{{"RAYCORE_DEVICE", "fpga"},
                                                                      {"RAYCORE_THREADS", "many"},
                                                                      {"RAYCORE_ACCEL", "octree"},
                                                                      {"RAYCORE_PROFILE", "2000"},
                                                                      {"RAYCORE_SAMPLES", "0"},
                                                                      {"RAYCORE_FRAMES", "-1"},
                                                                      {"RAYCORE_LOG", "loud"},
                                                                      {"RAYCORE_INSTRUCTION_SET", "avx9"},
                                                                      {"RAYCORE_MEMORY_LIMIT", "plenty"},
                                                                      {"RAYCORE_PIPELINE", "maybe"},
                                                                      {"RAYCORE_TEST", "yes"}}) {
    sVariables = {{name, value}};
    std::string report;
    EXPECT_EQ(read(report), Settings{}) << name;
    EXPECT_NE(report.find(name + "=" + value), std::string::npos) << report;
  }
}

TEST(Settings, BytesHaveUnits) {
  const std::pair<const char *, uint64_t> values[] = {{"1", 1},
                                                      {"3000", 3000},
                                                      {"64K", 65536},
                                                      {"1.5g", uint64_t(3) << 29},
                                                      {"2T", 2ull << 40},
                                                      {"0.5k", 512},
                                                      {"none", UINT64_MAX},
                                                      {"0", 0},
                                                      {"-5", 0},
                                                      {"1e3", 0},
                                                      {"5X", 0},
                                                      {"5 M", 0},
                                                      {"G", 0},
                                                      {"99999999999G", 0},
                                                      {"nan", 0},
                                                      {"inf", 0}};
  for (const auto &[text, bytes] : values) {
    sVariables = {{"RAYCORE_MEMORY_LIMIT", text}};
    std::string report;
    EXPECT_EQ(read(report).memoryLimit, bytes) << text;
    EXPECT_EQ(report.empty(), bytes != 0) << text;
  }
}

TEST(Settings, EmptyMeansUnset) {
  sVariables = {{"RAYCORE_THREADS", ""}, {"RAYCORE_ACCEL", ""}};
  std::string report;
  EXPECT_EQ(read(report), Settings{});
  EXPECT_EQ(report, "");
}

}  // namespace
}  // namespace rc::test
