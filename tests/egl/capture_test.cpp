// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// RAYCORE_CAPTURE: names of files, both formats, what cannot be written.
#include "egl/capture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "images/picture.h"

namespace rc::test {
namespace {

using egl::captureName;
using egl::writePicture;

TEST(Capture, Names) {
  EXPECT_EQ(captureName("a.png", 7), "a.png");
  EXPECT_EQ(captureName("f-%04d.png", 7), "f-0007.png");
  EXPECT_EQ(captureName("f-%d.png", 12), "f-12.png");
  EXPECT_EQ(captureName("f-%3d.png", 7), "f-  7.png");
  EXPECT_EQ(captureName("f-%02d.png", 12345), "f-12345.png");
  EXPECT_EQ(captureName("50%-%s-%d.png", 1), "50%-%s-1.png");
  EXPECT_EQ(captureName("%999999d%n%s", 1), "%999999d%n%s") << "never a format of printf";
  EXPECT_EQ(captureName("ends with %", 1), "ends with %");
}

class CaptureFile : public testing::Test {
 protected:
  CaptureFile() : mFolder(std::filesystem::temp_directory_path() / ("raycore-capture-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(mFolder);
  }
  ~CaptureFile() override { std::filesystem::remove_all(mFolder); }
  std::string file(const char *name) const { return (mFolder / name).string(); }

  std::filesystem::path mFolder;
  uint32_t mPixels[6] = {0xff0000ff, 0xff00ff00, 0xffff0000, 0xff010203, 0xff000000, 0xffffffff};
  hal::Target mPicture{mPixels, 3, 2};
};

TEST_F(CaptureFile, Png) {
  ASSERT_TRUE(writePicture(file("a.png"), mPicture));
  const Picture read = readPng(file("a.png"));
  ASSERT_EQ(read.width, 3);
  ASSERT_EQ(read.height, 2);
  EXPECT_EQ(read.at(0, 0), (Pixel{255, 0, 0}));
  EXPECT_EQ(read.at(0, 1), (Pixel{3, 2, 1}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(mFolder), {}), 1) << "and nothing else is left there";
}

TEST_F(CaptureFile, OfSeveralThreadsOneStays) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) EXPECT_TRUE(writePicture(file("a.png"), mPicture));
    });
  }
  for (std::thread &thread : threads) thread.join();
  EXPECT_EQ(readPng(file("a.png")).at(0, 1), (Pixel{3, 2, 1}));
}

TEST_F(CaptureFile, Ppm) {
  ASSERT_TRUE(writePicture(file("a.ppm"), mPicture));
  std::ifstream in(file("a.ppm"), std::ios::binary);
  const std::string all((std::istreambuf_iterator<char>(in)), {});
  ASSERT_EQ(all.size(), 11u + 18u);
  EXPECT_EQ(all.substr(0, 11), "P6\n3 2\n255\n");
  EXPECT_EQ(all.substr(11, 3), std::string("\xff\0\0", 3));
}

TEST_F(CaptureFile, AFolderThatDoesNotExistIsReported) {
  testing::internal::CaptureStderr();
  EXPECT_FALSE(writePicture(file("none/a.png"), mPicture));
  const std::string message = testing::internal::GetCapturedStderr();
  EXPECT_NE(message.find("none/a.png"), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

}  // namespace
}  // namespace rc::test
