// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Real windows in a virtual X server: what they show, resizing, keys, the close button, exit codes.
#include <X11/keysym.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "common/expressions.h"
#include "images/run_example.h"
#include "window/x11_fixture.h"

namespace rc::test {
namespace {

struct Server {
  const char *name;
  std::vector<std::string> options;
};

void PrintTo(const Server &server, std::ostream *out) { *out << server.name; }

const Server kServers[] = {
    {"SharedMemory", {"-screen", "0", "1280x960x24"}},
    {"WithoutSharedMemory", {"-screen", "0", "1280x960x24", "-extension", "MIT-SHM"}},
};

class WindowTest : public testing::TestWithParam<Server> {
 protected:
  void SetUp() override {
    if (!XServer::available()) GTEST_SKIP() << "Xvfb is not installed; scripts/setup.sh does it";
    mServer.emplace(GetParam().options);
    ASSERT_TRUE(mServer->connection()) << "Xvfb did not start";
    mCapture =
        (std::filesystem::temp_directory_path() / ("raycore-window-" + std::to_string(getpid()) + ".png")).string();
  }
  void TearDown() override {
    mProgram.reset();
    std::error_code ignored;
    std::filesystem::remove(mCapture, ignored);
  }

  // Starts an example and waits for its window.
  void start(const std::string &example, const std::string &title) {
    mProgram.emplace(std::vector<std::string>{(std::filesystem::path(RAYCORE_EXAMPLES_DIR) / example).string()},
                     std::vector<std::string>{"DISPLAY=" + mServer->name(), "RAYCORE_CAPTURE=" + mCapture});
    ASSERT_TRUE(eventually([&] { return (mWindow = mServer->find(title)) != 0; })) << "no window \"" << title << "\"";
  }

  bool comesToShow(Pixel colour) {
    return eventually([&] {
      const Picture shown = mServer->screenshot(mWindow);
      return !shown.empty() && shown.at(0, 0) == colour;
    });
  }

  // Whether the window comes to show just what was traced for it.
  bool showsItsPicture(int width, int height) {
    return eventually([&] {
      const Picture shown = mServer->screenshot(mWindow), traced = readPng(mCapture);
      return shown.width == width && shown.height == height && shown.rgb == traced.rgb;
    });
  }

  std::optional<XServer> mServer;
  std::optional<Process> mProgram;
  std::string mCapture;
  Window mWindow = 0;
};

const char *const kExample = "02_5a_perspective";
const char *const kTitle = "Chapter 2.5 a";

TEST_P(WindowTest, ShowsThePictureAndTheFrameRate) {
  start(kExample, kTitle);
  if (HasFatalFailure()) return;
  EXPECT_TRUE(showsItsPicture(800, 480));
  const ExampleRun headless = runExample(kExample, 1);
  EXPECT_EQ(mServer->screenshot(mWindow).rgb, headless.picture.rgb) << "as without a window";
  EXPECT_TRUE(eventually([&] {
    const std::string title = mServer->titleOf(mWindow);
    return matches(title, " : [0-9.]+ fps \\(draw [0-9.]+ ms, trace [0-9.]+ ms, show [0-9.]+ ms\\)$");
  })) << mServer->titleOf(mWindow);
}

TEST_P(WindowTest, FollowsTheSizeOfTheWindow) {
  start(kExample, kTitle);
  if (HasFatalFailure()) return;
  ASSERT_TRUE(showsItsPicture(800, 480));
  const Picture before = mServer->screenshot(mWindow);
  mServer->resize(mWindow, 900, 600);
  ASSERT_TRUE(showsItsPicture(900, 600));
  // The viewport stays: its picture lies at the lower left, the rest has the clear colour. [spec 3.1]
  const Picture larger = mServer->screenshot(mWindow);
  for (int y = 0; y < 480; y += 7) {
    for (int x = 0; x < 800; x += 7) ASSERT_EQ(larger.at(x, y + 120), before.at(x, y)) << x << ", " << y;
  }
  EXPECT_EQ(larger.at(850, 10), before.at(0, 0));
  mServer->resize(mWindow, 320, 200);
  EXPECT_TRUE(showsItsPicture(320, 200));
}

TEST_P(WindowTest, EscapeEndsTheProgram) {
  start(kExample, kTitle);
  if (HasFatalFailure()) return;
  ASSERT_TRUE(showsItsPicture(800, 480));
  mServer->pressKey(mWindow, XK_Escape);
  EXPECT_EQ(mProgram->exitCode(), 0);
}

TEST_P(WindowTest, TheCloseButtonEndsTheProgram) {
  start("06_5b_reflection", "Chapter 6.5 b");
  if (HasFatalFailure()) return;
  mServer->pressCloseButton(mWindow);
  EXPECT_EQ(mProgram->exitCode(), 0);
}

TEST_P(WindowTest, KeysReachTheProgram) {
  start("09_4_cornell_box", "Chapter 9.4");
  if (HasFatalFailure()) return;
  // Shadows off: the dark floor under the jumping block becomes as light as the floor beside it.
  const auto shadowed = [&] {
    const Picture shown = mServer->screenshot(mWindow);
    return !shown.empty() && shown.at(250, 400)[0] < 20;
  };
  ASSERT_TRUE(eventually(shadowed));
  mServer->pressKey(mWindow, XK_s);
  EXPECT_TRUE(eventually([&] { return !shadowed(); }));
  EXPECT_TRUE(mProgram->running());
}

TEST_P(WindowTest, AltEnterFillsTheScreenAndBack) {
  start(kExample, kTitle);
  if (HasFatalFailure()) return;
  ASSERT_TRUE(showsItsPicture(800, 480));
  mServer->pressKey(mWindow, XK_Return, Mod1Mask);
  EXPECT_TRUE(showsItsPicture(1280, 960));
  mServer->pressKey(mWindow, XK_Return, Mod1Mask);
  EXPECT_TRUE(showsItsPicture(800, 480));
  mServer->pressKey(mWindow, XK_Return);
  EXPECT_TRUE(mProgram->running());
}

constexpr uint8_t kLeft = 1, kRight = 2;  // [reference 6.1]
constexpr uint8_t kFastest = 16;          // the rendering hint, as the program shows it

// The program shows in the colour of its picture what it was told.
TEST_P(WindowTest, MouseAndKeysReachTheVirtualMethods) {
  start(RAYCORE_INPUT_PROGRAM, "Input");
  if (HasFatalFailure()) return;
  EXPECT_TRUE(comesToShow({0, 0, 0}));
  mServer->moveMouse(mWindow, 100, 25);  // of 200 x 100
  EXPECT_TRUE(comesToShow({128, 64, 0}));
  mServer->pressButton(mWindow, Button1, 50, 50, 0);
  EXPECT_TRUE(comesToShow({64, 128, kLeft * 16}));
  mServer->pressButton(mWindow, Button3, 50, 50, Button1Mask);
  EXPECT_TRUE(comesToShow({64, 128, (kLeft | kRight) * 16}));
  mServer->releaseButton(mWindow, Button1, 100, 50, Button1Mask | Button3Mask);
  EXPECT_TRUE(comesToShow({128, 128, kRight * 16}));
  mServer->pressKey(mWindow, XK_z);
  EXPECT_TRUE(comesToShow({'Z', kFastest, 255}));
  mServer->pressKey(mWindow, XK_KP_7);
  EXPECT_TRUE(comesToShow({'7', kFastest, 255}));
}

TEST_P(WindowTest, KeyIBringsTheStartValuesBack) {
  start(RAYCORE_INPUT_PROGRAM, "Input");
  if (HasFatalFailure()) return;
  for (int i = 0; i < 2; ++i) mServer->pressKey(mWindow, XK_Up);
  mServer->pressKey(mWindow, XK_z);
  EXPECT_TRUE(comesToShow({'Z', 3 * kFastest, 255})) << "another rendering hint";
  mServer->pressKey(mWindow, XK_i);
  EXPECT_TRUE(comesToShow({'I', kFastest, 255}));
}

// We are the window manager: it decides how large a window is before it is there.
TEST_P(WindowTest, AWindowManagerHasSizesOfItsOwn) {
  Display *x = mServer->connection();
  XSelectInput(x, DefaultRootWindow(x), SubstructureRedirectMask);
  XSync(x, False);
  mProgram.emplace(std::vector<std::string>{RAYCORE_INPUT_PROGRAM},
                   std::vector<std::string>{"DISPLAY=" + mServer->name()});
  XEvent event;
  ASSERT_TRUE(eventually([&] { return XCheckTypedEvent(x, MapRequest, &event) == True; }));
  mWindow = event.xmaprequest.window;
  XResizeWindow(x, mWindow, 100, 50);
  XMapWindow(x, mWindow);
  XSync(x, False);
  mServer->moveMouse(mWindow, 50, 25);
  EXPECT_TRUE(comesToShow({128, 128, 0})) << "in the middle of it";
}

TEST_P(WindowTest, AWindowOfTheLibrarysOwn) {
  start("d_1_5_egl", "RayCore");
  if (HasFatalFailure()) return;
  const auto showsSomething = [&] {
    const Picture shown = mServer->screenshot(mWindow);
    return shown.width == 800 && shown.at(0, 0) == Pixel{186, 51, 58};
  };
  EXPECT_TRUE(eventually(showsSomething));
  mServer->pressCloseButton(mWindow);
  EXPECT_EQ(mProgram->exitCode(), 0);
  start("d_1_5_egl", "RayCore");
  if (HasFatalFailure()) return;
  mServer->pressKey(mWindow, XK_Escape);
  EXPECT_EQ(mProgram->exitCode(), 0);
}

TEST_P(WindowTest, AServerThatGoesAwayEndsTheProgramWithoutACrash) {
  start(kExample, kTitle);
  if (HasFatalFailure()) return;
  ASSERT_TRUE(showsItsPicture(800, 480));
  mServer.reset();
  const std::optional<int> code = mProgram->exitCode();
  ASSERT_TRUE(code.has_value()) << "it hangs";
  EXPECT_LT(*code, 128) << "it was ended by a signal";
}

std::string nameOf(const testing::TestParamInfo<Server> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(X11, WindowTest, testing::ValuesIn(kServers), nameOf);

}  // namespace
}  // namespace rc::test
