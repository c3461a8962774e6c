// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The vendor's own functions beside EGL's. [reference 1.5]
#include "egl/vendor_calls.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

class VendorCalls : public Egl {
 protected:
  void TearDown() override {
    std::filesystem::remove(mFile);
    Egl::TearDown();
  }
  std::filesystem::path mFile =
      std::filesystem::temp_directory_path() / ("raycore-dump-" + std::to_string(getpid()) + ".txt");
};

TEST_F(VendorCalls, TheDumpNamesDeviceAndObjects) {
  eglDumpSystemRC(mDisplay, mFile.c_str());
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
  std::stringstream text;
  text << std::ifstream(mFile).rdbuf();
  EXPECT_NE(text.str().find("device: "), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("contexts: 0"), std::string::npos) << text.str();
}

TEST_F(VendorCalls, WhatCannotBeWritten) {
  eglDumpSystemRC(mDisplay, "/nonexistent/dump.txt");
  EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
  eglDumpSystemRC(mDisplay, nullptr);
  EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
  eglDumpSystemRC(EGL_NO_DISPLAY, mFile.c_str());
  EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
}

TEST_F(VendorCalls, ThereIsOneDevice) {
  int count = 0, report = 7;
  EXPECT_EQ(eglGetReportRegister(mDisplay, &count, nullptr), EGLBoolean(EGL_TRUE));
  EXPECT_EQ(count, 1);
  EXPECT_EQ(eglGetReportRegister(mDisplay, &count, &report), EGLBoolean(EGL_FALSE));
  EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
  EXPECT_EQ(report, 7) << "its layout is not known: nothing is written";
}

}  // namespace
}  // namespace rc::test
