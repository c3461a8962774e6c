// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore view in a virtual X server: each of its functions by real key and mouse events, seen in its window.
#include <X11/Xatom.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "window/x11_fixture.h"

namespace rc::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 240, kHeight = 180;
constexpr int kMessage = 40;  // rows at the bottom where messages stand

// Rows from the first to before the last one.
std::vector<uint8_t> rowsOf(const Picture &picture, int first, int last) {
  if (picture.empty()) return {};
  return {picture.rgb.begin() + std::ptrdiff_t(first) * picture.width * 3,
          picture.rgb.begin() + std::ptrdiff_t(last) * picture.width * 3};
}
std::vector<uint8_t> sceneOf(const Picture &picture) { return rowsOf(picture, 0, picture.height - kMessage); }

class ViewTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!XServer::available()) GTEST_SKIP() << "Xvfb is not installed; scripts/setup.sh does it";
    if (std::system("command -v xdotool >/dev/null") != 0) GTEST_SKIP() << "xdotool is not installed";
    mServer.emplace(std::vector<std::string>{"-screen", "0", "640x480x24"});
    ASSERT_TRUE(mServer->connection()) << "Xvfb did not start";
    mFolder = fs::temp_directory_path() / ("raycore-view-" + std::to_string(getpid()));
    fs::create_directory(mFolder);
    fs::copy_file(fs::path(RAYCORE_MODELS) / "room.gltf", model());
  }
  void TearDown() override {
    mViewer.reset();
    std::error_code ignored;
    fs::remove_all(mFolder, ignored);
  }

  fs::path model() const { return mFolder / "a room.gltf"; }

  // The viewer at rest, with one sample a pixel, and the pointer in its window.
  void start() {
    mViewer.emplace(std::vector<std::string>{"sh", "-c",
                                             "cd '" + mFolder.string() + "' && exec '" RAYCORE_TOOL "' view '" +
                                                 model().string() + "' --size 240x180 --samples 1 >said 2>&1"},
                    std::vector<std::string>{"DISPLAY=" + mServer->name()});
    ASSERT_TRUE(waitFor([&] { return (mWindow = mServer->find("a room.gltf - raycore")) != 0; })) << said();
    input("mousemove 120 90");
    mHome = atRest();
    ASSERT_FALSE(mHome.empty()) << said();
  }

  static bool waitFor(const std::function<bool()> &condition) {
    for (int i = 0; i < 6; ++i) {
      if (eventually(condition)) return true;
    }
    return false;
  }

  // Real events, by XTEST.
  void input(const std::string &commands) const {
    const std::string line = "DISPLAY=" + mServer->name() + " xdotool " + commands;
    EXPECT_EQ(std::system(line.c_str()), 0) << line;
  }
  void key(const std::string &name) const { input("key " + name); }
  void drag(int button, int x, int y, const std::string &held = "") const {
    const std::string down = held.empty() ? "" : "keydown " + held + " ", up = held.empty() ? "" : " keyup " + held;
    input(down + "mousemove 120 90 mousedown " + std::to_string(button) +
          " mousemove_relative -- 5 5 mousemove_relative -- " + std::to_string(x) + " " + std::to_string(y) +
          " mouseup " + std::to_string(button) + up);
  }

  bool rested() const { return mServer->titleOf(mWindow).ends_with(" 1/1"); }
  Picture atRest() const {
    Picture picture;
    waitFor([&] {
      picture = mServer->screenshot(mWindow);
      return rested() && picture.rgb == mServer->screenshot(mWindow).rgb;
    });
    return picture;
  }
  // The scene after something was done that changes it.
  Picture changedFrom(const Picture &before) const {
    EXPECT_TRUE(waitFor([&] { return rested() && sceneOf(mServer->screenshot(mWindow)) != sceneOf(before); }));
    return atRest();
  }
  void expectScene(const Picture &wanted) const {
    EXPECT_TRUE(waitFor([&] { return rested() && sceneOf(mServer->screenshot(mWindow)) == sceneOf(wanted); }));
  }

  std::string said() const {
    std::ifstream file(mFolder / "said");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  bool saysAtLast(const std::string &what) const {
    return waitFor([&] { return said().find(what) != std::string::npos; });
  }

  // `raycore render` of the model.
  Picture rendered(const fs::path &file, const std::string &options) const {
    const std::string picture = (mFolder / "rendered.png").string();
    const std::string command =
        RAYCORE_TOOL " render '" + file.string() + "' -q --size 240x180 --samples 1 -o '" + picture + "' " + options;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return readPng(picture);
  }

  std::optional<XServer> mServer;
  std::optional<Process> mViewer;
  fs::path mFolder;
  Window mWindow = 0;
  Picture mHome;
};

TEST_F(ViewTest, ShowsWhatRenderWrites) {
  ASSERT_NO_FATAL_FAILURE(start());
  EXPECT_EQ(mHome.rgb, rendered(model(), "").rgb);
}

TEST_F(ViewTest, MouseMovesTheViewer) {
  ASSERT_NO_FATAL_FAILURE(start());
  const struct {
    const char *name;
    std::function<void()> act;
  } ways[] = {{"orbit", [&] { drag(1, 60, 20); }},           {"pan", [&] { drag(3, 40, 0); }},
              {"pan", [&] { drag(1, 0, 40, "shift"); }},     {"look", [&] { drag(1, 40, 0, "ctrl"); }},
              {"closer", [&] { input("click 4 click 4"); }}, {"farther", [&] { input("click 5 click 5"); }}};
  std::vector<std::vector<uint8_t>> seen{sceneOf(mHome)};
  for (const auto &[name, act] : ways) {
    SCOPED_TRACE(name);
    act();
    const std::vector<uint8_t> scene = sceneOf(changedFrom(mHome));
    for (const auto &other : seen) EXPECT_NE(scene, other);
    seen.push_back(scene);
    key("r");
    expectScene(mHome);
  }
}

TEST_F(ViewTest, KeysFly) {
  ASSERT_NO_FATAL_FAILURE(start());
  for (const char *name : {"w", "s", "a", "d", "Prior", "Next"}) {
    SCOPED_TRACE(name);
    input(std::string("keydown ") + name + " sleep 0.2 keyup " + name);
    changedFrom(mHome);
    key("r");
    expectScene(mHome);
  }
}

TEST_F(ViewTest, FrameAllShowsTheWholeModel) {
  ASSERT_NO_FATAL_FAILURE(start());
  input("click 4 click 4 click 4");
  changedFrom(mHome);
  key("f");
  expectScene(mHome);
}

TEST_F(ViewTest, CamerasOfTheFileFollowEachOther) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("c");
  const Picture front = changedFrom(mHome);
  key("c");
  const Picture above = changedFrom(front);
  EXPECT_NE(sceneOf(above), sceneOf(mHome));
  key("c");
  expectScene(mHome);
}

TEST_F(ViewTest, AnimationsPlayPauseAndScrub) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("Right");
  changedFrom(mHome);
  key("Left");
  expectScene(mHome);
  key("space");  // the title never comes to rest while it plays
  Picture last = mHome;
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(waitFor([&] { return sceneOf(mServer->screenshot(mWindow)) != sceneOf(last); }));
    last = mServer->screenshot(mWindow);
  }
  key("space");
  const Picture paused = atRest();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(mServer->screenshot(mWindow).rgb, paused.rgb);
}

TEST_F(ViewTest, SwitchesChangeThePicture) {
  ASSERT_NO_FATAL_FAILURE(start());
  const struct {
    const char *there, *back;
    int times;
  } switches[] = {{"minus", "plus", 10}, {"x", "x", 1}};
  for (const auto &[there, back, times] : switches) {
    SCOPED_TRACE(there);
    const std::string repeat = "key --repeat " + std::to_string(times) + " ";
    input(repeat + there);
    changedFrom(mHome);
    input(repeat + back);
    expectScene(mHome);
  }
  Picture filtered = mHome;
  for (const char *filter : {"trilinear", "bilinear", "base level alone"}) {
    SCOPED_TRACE(filter);
    key("t");
    filtered = changedFrom(filtered);
  }
  key("t");
  expectScene(mHome);
}

// Another structure, the same picture; the message names it.
TEST_F(ViewTest, StructuresGiveTheSamePicture) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("k");
  EXPECT_TRUE(waitFor([&] { return rested() && mServer->screenshot(mWindow).rgb != mHome.rgb; }));
  const Picture kdTree = atRest();
  EXPECT_EQ(sceneOf(kdTree), sceneOf(mHome));
  key("k");
  EXPECT_TRUE(waitFor([&] { return rested() && mServer->screenshot(mWindow).rgb != kdTree.rgb; }));
  EXPECT_EQ(sceneOf(atRest()), sceneOf(mHome));
}

TEST_F(ViewTest, StatisticsAndHelpComeAndGo) {
  ASSERT_NO_FATAL_FAILURE(start());
  std::vector<uint8_t> statistics;
  for (const char *name : {"i", "h"}) {
    key(name);
    const Picture shown = changedFrom(mHome);
    EXPECT_NE(sceneOf(shown), statistics);
    statistics = sceneOf(shown);
    key(name);
    expectScene(mHome);
  }
}

TEST_F(ViewTest, ScreenshotsHaveThePictureWithoutText) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("h");
  changedFrom(mHome);
  key("p");
  key("p");
  for (const char *name : {"raycore-0001.png", "raycore-0002.png"}) {
    EXPECT_TRUE(waitFor([&] { return readPng((mFolder / name).string()).rgb == mHome.rgb; })) << name;
  }
}

TEST_F(ViewTest, FullScreenAndBack) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("F11");
  EXPECT_TRUE(waitFor([&] {
    const Picture shown = mServer->screenshot(mWindow);
    return shown.width == 640 && shown.height == 480 && rested();
  }));
  key("F11");
  EXPECT_TRUE(waitFor([&] { return mServer->screenshot(mWindow).width == kWidth; }));
  EXPECT_EQ(atRest().rgb, mHome.rgb);
}

TEST_F(ViewTest, AClickTellsMaterialAndDistance) {
  ASSERT_NO_FATAL_FAILURE(start());
  const struct {
    int x, y;
    const char *material;
  } places[] = {{105, 110, "Red: distance "}, {140, 130, "Floor: distance "}, {190, 75, "Mirror: distance "}};
  for (const auto &[x, y, material] : places) {
    input("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
    EXPECT_TRUE(saysAtLast(material)) << said();
  }
  EXPECT_EQ(sceneOf(atRest()), sceneOf(mHome)) << "a click moves nothing";
}

TEST_F(ViewTest, AFileThatChangesIsReadAgain) {
  ASSERT_NO_FATAL_FAILURE(start());
  std::ofstream(model()) << "{ damaged";
  EXPECT_TRUE(waitFor([&] { return mServer->screenshot(mWindow).rgb != mHome.rgb; })) << "a message";
  EXPECT_EQ(sceneOf(atRest()), sceneOf(mHome)) << "what was there stays";
  EXPECT_TRUE(mViewer->running());
  const fs::path next = mFolder / "next.gltf";
  fs::copy_file(fs::path(RAYCORE_MODELS) / "triangle.gltf", next);
  fs::rename(next, model());
  changedFrom(mHome);
  key("r");
  const Picture triangle = rendered(model(), "");
  expectScene(triangle);
}

// The other side of XDND: a window that has a file to give.
class DragSource {
 public:
  DragSource(Display *display, Window target, const std::string &uri) : mDisplay(display), mTarget(target), mUri(uri) {
    mWindow = XCreateSimpleWindow(display, DefaultRootWindow(display), 600, 400, 10, 10, 0, 0, 0);
    XSetSelectionOwner(display, atom("XdndSelection"), mWindow, CurrentTime);
  }
  ~DragSource() { XDestroyWindow(mDisplay, mWindow); }

  // What the target says in the end: 1 if it took the file.
  long drop() {
    send("XdndEnter", {5L << 24, long(atom("text/uri-list")), 0, 0});
    send("XdndPosition", {0, (100 << 16) + 100, CurrentTime, long(atom("XdndActionCopy"))});
    if (!(waitForMessage("XdndStatus") & 1)) return 0;
    send("XdndDrop", {0, CurrentTime, 0, 0});
    return waitForMessage("XdndFinished") & 1;
  }

 private:
  Atom atom(const char *name) const { return XInternAtom(mDisplay, name, False); }

  void send(const char *type, const std::array<long, 4> &values) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = mTarget;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = long(mWindow);
    for (size_t i = 0; i < values.size(); ++i) event.xclient.data.l[i + 1] = values[i];
    XSendEvent(mDisplay, mTarget, False, NoEventMask, &event);
    XSync(mDisplay, False);
  }

  long waitForMessage(const char *type) {
    long flags = 0;
    EXPECT_TRUE(eventually([&] {
      XEvent event;
      while (XPending(mDisplay) > 0) {
        XNextEvent(mDisplay, &event);
        if (event.type == SelectionRequest) give(event.xselectionrequest);
        if (event.type != ClientMessage || event.xclient.message_type != atom(type)) continue;
        flags = event.xclient.data.l[1];
        return true;
      }
      return false;
    })) << type;
    return flags;
  }

  void give(const XSelectionRequestEvent &request) const {
    XChangeProperty(mDisplay, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char *>(mUri.data()), int(mUri.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    XSendEvent(mDisplay, request.requestor, False, NoEventMask, &event);
    XSync(mDisplay, False);
  }

  Display *mDisplay;
  Window mTarget, mWindow = 0;
  std::string mUri;
};

TEST_F(ViewTest, ADroppedFileIsShown) {
  ASSERT_NO_FATAL_FAILURE(start());
  const fs::path other = mFolder / "other one.gltf";
  fs::copy_file(fs::path(RAYCORE_MODELS) / "triangle.gltf", other);
  const std::string uri = "file://" + mFolder.string() + "/other%20one.gltf\r\n";
  EXPECT_EQ(DragSource(mServer->connection(), mWindow, uri).drop(), 1);
  expectScene(rendered(other, ""));
  EXPECT_TRUE(mServer->titleOf(mWindow).starts_with("other one.gltf"));
}

TEST_F(ViewTest, EndsWithCodeZero) {
  ASSERT_NO_FATAL_FAILURE(start());
  key("q");
  EXPECT_EQ(mViewer->exitCode().value_or(-1), 0);
  ASSERT_NO_FATAL_FAILURE(start());
  mServer->pressCloseButton(mWindow);
  EXPECT_EQ(mViewer->exitCode().value_or(-1), 0);
}

}  // namespace
}  // namespace rc::test
