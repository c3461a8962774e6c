// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Thirty scenes drawn by processes that differ in what a picture must not depend on: threads, frames before, where
// memory lies, the processor's mode for floats; and in the instruction set, on which a last bit may.
#include <gtest/gtest.h>
#include <sys/personality.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <string>

#include "api/thirty_scenes.h"

namespace rc::test {
namespace {

struct Conditions {
  std::map<std::string, std::string> environment;
  std::string framesBefore = "0";
  bool randomAddresses = true;
};

#ifdef RAYCORE_FEW_TARGETS  // sanitizers are slow
constexpr const char *kMostFramesBefore = "2";
#else
constexpr const char *kMostFramesBefore = "5";
#endif

using Pixels = std::vector<uint32_t>;

[[noreturn]] void become(const Conditions &conditions, int output) {
  dup2(output, STDOUT_FILENO);
  const int mode = personality(0xffffffff);
  if (!conditions.randomAddresses && personality((unsigned long)mode | ADDR_NO_RANDOMIZE) < 0) _exit(3);
  for (const auto &[name, value] : conditions.environment) setenv(name.c_str(), value.c_str(), 1);
  execl(RAYCORE_SCENE_PROGRAM, RAYCORE_SCENE_PROGRAM, conditions.framesBefore.c_str(), nullptr);
  _exit(2);
}

Pixels pixelsOf(const Conditions &conditions) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) become(conditions, ends[1]);
  close(ends[1]);
  Pixels pixels(kScenes * kScenePixels + 1);
  const size_t room = pixels.size() * sizeof(uint32_t);
  size_t have = 0;
  for (ssize_t got;
       have < room && (got = read(ends[0], reinterpret_cast<char *>(pixels.data()) + have, room - have)) > 0;) {
    have += size_t(got);
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(have, kScenes * kScenePixels * sizeof(uint32_t));
  pixels.resize(kScenes * kScenePixels);
  return pixels;
}

// On one thread, with nothing before.
const Pixels &truth() {
  static const Pixels pixels = pixelsOf({{{"RAYCORE_THREADS", "1"}}});
  return pixels;
}

void expectSameBytes(const Conditions &conditions) {
  const Pixels pixels = pixelsOf(conditions);
  for (int scene = 0; scene < kScenes; ++scene) {
    const auto first = std::ptrdiff_t(size_t(scene) * kScenePixels), end = first + std::ptrdiff_t(kScenePixels);
    EXPECT_TRUE(std::equal(pixels.begin() + first, pixels.begin() + end, truth().begin() + first)) << "scene " << scene;
  }
}

TEST(Determinism, TheScenesShowSomething) {
  for (int scene = 0; scene < kScenes; ++scene) {
    const uint32_t *pixels = truth().data() + size_t(scene) * kScenePixels;
    EXPECT_TRUE(std::any_of(pixels, pixels + kScenePixels, [&](uint32_t p) { return p != pixels[0]; })) << scene;
  }
}

TEST(Determinism, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const char *threads : {"2", "7"}) {
    SCOPED_TRACE(threads);
    expectSameBytes({{{"RAYCORE_THREADS", threads}}});
  }
}

TEST(Determinism, FramesBeforeLeaveNothing) {
  expectSameBytes({{{"RAYCORE_THREADS", "1"}}, "1"});
  expectSameBytes({{{"RAYCORE_THREADS", "2"}}, kMostFramesBefore});
}

TEST(Determinism, WhereMemoryLiesDoesNotMatter) {
  const std::map<std::string, std::string> threads{{"RAYCORE_THREADS", "2"}};
  expectSameBytes({threads, "0", false});
  expectSameBytes({threads, "0", true});
  // Memory that is not zero at first, and none that is mapped apart.
  expectSameBytes(
      {{{"RAYCORE_THREADS", "2"}, {"GLIBC_TUNABLES", "glibc.malloc.perturb=165"}, {"MALLOC_PERTURB_", "90"}}});
  expectSameBytes(
      {{{"RAYCORE_THREADS", "2"}, {"MALLOC_TOP_PAD_", "100000000"}, {"MALLOC_MMAP_THRESHOLD_", "1000000000"}}});
}

// Sums are added in another order, by which a byte can fall to its neighbour: at most 1 of 255, in 1 pixel of 10000.
class InstructionSets : public testing::TestWithParam<const char *> {};

TEST_P(InstructionSets, HardlyChangeAByte) {
  const Pixels pixels = pixelsOf({{{"RAYCORE_THREADS", "2"}, {"RAYCORE_INSTRUCTION_SET", GetParam()}}});
  size_t different = 0;
  for (size_t i = 0; i < pixels.size(); ++i) {
    different += pixels[i] != truth()[i];
    for (int shift = 0; shift < 32; shift += 8) {
      ASSERT_NEAR(int(pixels[i] >> shift & 255), int(truth()[i] >> shift & 255), 1)
          << "scene " << i / kScenePixels << ", pixel " << i % kScenePixels;
    }
  }
  RecordProperty("pixels", int(pixels.size()));
  RecordProperty("different", int(different));
  EXPECT_LE(different, pixels.size() / 10000);
}

INSTANTIATE_TEST_SUITE_P(Each, InstructionSets, testing::Values("baseline", "ssse3", "sse4", "avx2", "avx512"),
                         [](const auto &set) { return std::string(set.param); });

}  // namespace
}  // namespace rc::test
