// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// RAYCORE_TRACE, as a user sees it: every call of an example in a file, and a line for each frame.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "common/expressions.h"
#include "images/run_example.h"

namespace rc::test {
namespace {

class TraceFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(mFile); }

  // The lines of a run of two frames.
  std::vector<std::string> trace(const std::string &example) {
    const ExampleRun run = runExample(example, 2, "RAYCORE_TRACE='" + mFile.string() + "'");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    std::vector<std::string> lines;
    std::ifstream file(mFile);
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }
  static size_t count(const std::vector<std::string> &lines, const std::string &pattern) {
    const auto found =
        std::count_if(lines.begin(), lines.end(), [&](const std::string &line) { return matches(line, pattern); });
    return size_t(found);
  }

  std::filesystem::path mFile =
      std::filesystem::temp_directory_path() / ("raycore-trace-" + std::to_string(getpid()) + ".txt");
};

TEST_F(TraceFile, HasEveryCallAndALineForEachFrame) {
  const std::vector<std::string> lines = trace("02_5a_perspective");
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(count(lines, "^(frame [1-9][0-9]*|no context): "), lines.size()) << "each belongs to a frame";
  EXPECT_GE(count(lines, "^frame 1: rcuPerspective\\(fovy = [0-9.]+, aspect = [0-9.]+, zNear = "), 1u);
  EXPECT_GE(count(lines, "rcVertexPointer\\(size = 3, type = RC_FLOAT, stride = 0, pointer = 0x"), 1u);
  EXPECT_GE(count(lines, "rcDrawElements\\(mode = RC_TRIANGLE_FAN, count = 3, type = RC_UNSIGNED_BYTE, indices = 0x"),
            1u);
  EXPECT_EQ(count(lines, "RC_INVALID"), 0u);
  // Nothing moves: one frame is traced.
  const std::string frame =
      ": 800 x 480, [1-9][0-9]* triangles \\([0-9]+ static, [0-9]+ dynamic\\), 0 skipped, .*light.*, "
      "[0-9]+ rays \\(384000 primary, of which [1-9][0-9]* met something, ";
  EXPECT_EQ(count(lines, "^frame 1" + frame), 1u);
}

TEST_F(TraceFile, FramesAreNumbered) {
  const std::vector<std::string> lines = trace("b_cube");
  for (const std::string frame : {"1", "2"}) {
    EXPECT_EQ(count(lines, "^frame " + frame + ": 800 x 480, "), 1u) << frame;
    EXPECT_GE(count(lines, "^frame " + frame + ": rcDraw"), 1u) << frame;
  }
}

TEST_F(TraceFile, ResultsAreWritten) {
  EXPECT_GE(count(trace("02_5a_perspective"), "rcGetError\\(\\) = RC_NO_ERROR$"), 1u);
}

TEST_F(TraceFile, AFileThatCannotBeWrittenIsNoReasonToEnd) {
  mFile = "/nonexistent/raycore-trace.txt";
  EXPECT_TRUE(trace("02_5a_perspective").empty());
}

}  // namespace
}  // namespace rc::test
