// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The door for memory that programs decide about: what is counted, refused, and given back.
#include "base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/large_pages.h"
#include "base/machine_memory.h"
#include "base/rows.h"

namespace rc::test {
namespace {

class MemoryLimit : public testing::Test {
 protected:
  void SetUp() override { setMemoryLimit(mBefore + 1000000); }
  void TearDown() override { setMemoryLimit(mOld); }

  size_t taken() const { return countedMemory() - mBefore; }

  const uint64_t mOld = memoryLimit();
  const size_t mBefore = countedMemory();
};

TEST_F(MemoryLimit, WhatIsTakenIsCountedAndGivenBack) {
  {
    Array<uint32_t> array(1000);
    EXPECT_EQ(taken(), 4000u);
    Rows<double> rows(1000);
    EXPECT_EQ(taken(), 12000u);
    LargeVector<char> large(5000);
    EXPECT_EQ(taken(), 12000u + 5056);
  }
  EXPECT_EQ(taken(), 0u);
}

TEST_F(MemoryLimit, SmallPiecesAreNotCounted) {
  const Array<char> small(kLeastCounted - 1);
  EXPECT_EQ(taken(), 0u);
}

TEST_F(MemoryLimit, MoreIsRefusedAndNothingIsLost) {
  const Array<char> most(1000000);
  EXPECT_THROW(Array<char>{}.resize(kLeastCounted), MemoryRefused);
  EXPECT_THROW(LargeVector<char>{}.resize(size_t(1) << 40), MemoryRefused);
  EXPECT_THROW(Rows<double>{}.resize(size_t(1) << 58), MemoryRefused);
  EXPECT_EQ(taken(), 1000000u);
}

TEST_F(MemoryLimit, WhatTheSystemRefusesIsNotCounted) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer ends the program that asks for so much";
#endif
  setMemoryLimit(UINT64_MAX);
  EXPECT_THROW(Array<char>{}.resize(size_t(1) << 60), std::bad_alloc);
  EXPECT_EQ(taken(), 0u);
}

TEST_F(MemoryLimit, SizesThatWrapRoundAreRefused) {
  setMemoryLimit(UINT64_MAX);
  EXPECT_THROW(Counted<double>().allocate(SIZE_MAX / 4), std::bad_alloc);
  EXPECT_THROW(LargePages<double>().allocate(SIZE_MAX / 4), std::bad_alloc);
  EXPECT_THROW(LargePages<char>().allocate(SIZE_MAX - 5), std::bad_alloc);
}

TEST_F(MemoryLimit, DefaultIsPartOfWhatTheMachineHas) {
  const uint64_t machine = uint64_t(sysconf(_SC_PHYS_PAGES)) * uint64_t(sysconf(_SC_PAGESIZE));
  EXPECT_LE(defaultMemoryLimit(), machine / 4 * 3);
  EXPECT_GT(defaultMemoryLimit(), uint64_t(1) << 24);
}

class ControlGroup : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "raycore-group-XXXXXX").string();
    ASSERT_TRUE(mkdtemp(name.data()));
    mRoot = name;
  }
  void TearDown() override { std::filesystem::remove_all(mRoot); }

  void write(const std::string &path, const std::string &text) const {
    std::filesystem::create_directories(std::filesystem::path(mRoot + path).parent_path());
    std::ofstream(mRoot + path) << text;
  }

  std::string mRoot;
};

TEST_F(ControlGroup, TheLeastLimitOnTheWayUpCounts) {
  write("/memory.max", "max\n");
  write("/a/memory.max", "3000\n");
  write("/a/b/memory.max", "5000\n");
  EXPECT_EQ(groupMemoryLimit(mRoot, "0::/a/b\n"), 3000u);
  EXPECT_EQ(groupMemoryLimit(mRoot, "0::/\n"), UINT64_MAX);
  EXPECT_EQ(groupMemoryLimit(mRoot, "0::/other\n"), UINT64_MAX);
}

TEST_F(ControlGroup, VersionOneHasAFolderForMemory) {
  write("/memory/a/memory.limit_in_bytes", "7000\n");
  EXPECT_EQ(groupMemoryLimit(mRoot, "4:cpu,cpuacct:/x\n3:memory:/a\n"), 7000u);
}

TEST_F(ControlGroup, NonsenseIsNoLimit) {
  EXPECT_EQ(groupMemoryLimit(mRoot, ""), UINT64_MAX);
  EXPECT_EQ(groupMemoryLimit(mRoot, "memory\n::\n:\n"), UINT64_MAX);
}

}  // namespace
}  // namespace rc::test
