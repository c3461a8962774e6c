// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Parts of the viewer that need no window: what is traced next, how the viewer moves, lists of files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "view/bindings.h"
#include "view/camera.h"
#include "view/canvas.h"
#include "view/drop.h"
#include "view/playback.h"
#include "view/refinement.h"
#include "view/watch.h"

namespace rc::tool {
namespace {

constexpr int kWidth = 800, kHeight = 480;

// A machine that takes this long for a picture, and for each pixel.
struct Machine {
  double picture, pixel;

  double seconds(const Refinement &refinement, const Pass &pass) const {
    return picture + pixel * refinement.widthOf(pass.step) * pass.rows;
  }
};

TEST(Refinement, MotionKeepsThirtyFramesASecond) {
  for (const Machine &machine : {Machine{0.001, 1e-8}, {0.001, 2e-7}, {0.001, 3e-6}, {0.01, 3e-6}, {0.015, 1e-6}}) {
    Refinement refinement(16);
    refinement.resize(kWidth, kHeight);
    for (int frame = 0; frame < 50; ++frame) {
      refinement.restart();
      const Pass pass = *refinement.next(true);
      EXPECT_EQ(pass.row, 0);
      const double seconds = machine.seconds(refinement, pass);
      if (frame > 3) {
        EXPECT_LT(seconds, 0.028) << "time is left for showing it; frame " << frame << ", pixel " << machine.pixel;
      }
      refinement.done(pass, seconds);
    }
    const int finer = refinement.step() - 1;
    if (finer > 0) {
      EXPECT_GT(machine.seconds(refinement, {finer, 0, 0, refinement.heightOf(finer)}), 0.018)
          << "no coarser than it must be";
    }
  }
}

TEST(Refinement, FastMachinesShowAllPixelsInMotion) {
  Refinement refinement(16);
  refinement.resize(kWidth, kHeight);
  for (int frame = 0; frame < 5; ++frame) {
    refinement.restart();
    refinement.done(*refinement.next(true), 0.01);
  }
  EXPECT_EQ(refinement.next(true)->step, 1);
}

TEST(Refinement, AtRestEveryRowGetsEverySampleOnce) {
  Refinement refinement(3);
  refinement.resize(kWidth, kHeight);
  refinement.done(*refinement.next(true), 1.0);
  refinement.restart();
  const Pass coarse = *refinement.next(false);
  EXPECT_GT(coarse.step, 1) << "at once";
  refinement.done(coarse, 0.02);
  std::vector<std::vector<int>> rows(3, std::vector<int>(kHeight));
  int passes = 0;
  for (auto pass = refinement.next(false); pass; pass = refinement.next(false)) {
    ASSERT_EQ(pass->step, 1);
    for (int row = pass->row; row < pass->row + pass->rows; ++row) ++rows[size_t(pass->sample)][size_t(row)];
    const double seconds = 1e-6 * kWidth * pass->rows;
    if (++passes > 1) {
      EXPECT_LT(seconds, 0.05) << "a key is answered soon";
    }
    refinement.done(*pass, seconds);
  }
  for (const auto &sample : rows) EXPECT_EQ(sample, std::vector<int>(kHeight, 1));
  EXPECT_EQ(refinement.samplesDone(), 3);
}

TEST(Canvas, SamplesAreAveraged) {
  Canvas canvas;
  canvas.resize(2, 3);
  const auto rows = [](int count, uint8_t value) {
    return Image{"", 2, count, std::vector<uint8_t>(size_t(count) * 8, value)};
  };
  canvas.addRows(rows(3, 10), 0, 0);
  canvas.addRows(rows(1, 40), 1, 1);  // the middle row
  EXPECT_EQ(canvas.image().rgba[0], 10);
  EXPECT_EQ(canvas.image().rgba[8], 25);
  EXPECT_EQ(canvas.image().rgba[16], 10);
  canvas.addRows(rows(1, 7), 0, 0);  // another picture begins at the lowest row
  EXPECT_EQ(canvas.image().rgba[16], 7);
}

TEST(Canvas, CoarsePicturesAreScaledSmoothly) {
  Canvas canvas;
  canvas.resize(4, 2);
  canvas.showCoarse({"", 2, 1, {0, 0, 0, 255, 200, 100, 40, 255}});
  const std::vector<uint8_t> &rgba = canvas.image().rgba;
  EXPECT_EQ(rgba[0], 0);
  EXPECT_EQ(rgba[4], 50);
  EXPECT_EQ(rgba[8], 150);
  EXPECT_EQ(rgba[12], 200);
  EXPECT_EQ(rgba[13], 100);
  EXPECT_TRUE(std::equal(rgba.begin(), rgba.begin() + 16, rgba.begin() + 16)) << "both rows";
}

View someView() {
  View view;
  view.eye = {3, 4, 5};
  view.centre = {1, 1, 1};
  return view;
}

CameraController controller() {
  CameraController camera;
  Bounds bounds;
  bounds.add(Vec3(0));
  bounds.add(Vec3(2));
  camera.place(someView(), bounds, false);
  return camera;
}

float distanceOf(const View &view) { return glm::length(view.eye - view.centre); }

TEST(CameraController, OrbitKeepsTheDistanceAndComesRound) {
  CameraController camera = controller();
  const View before = camera.view();
  camera.orbit(1, 0.2f);
  EXPECT_EQ(camera.view().centre, before.centre);
  EXPECT_NEAR(distanceOf(camera.view()), distanceOf(before), 1e-5f);
  EXPECT_GT(glm::length(camera.view().eye - before.eye), 1);
  camera.orbit(-1, -0.2f);
  EXPECT_LT(glm::length(camera.view().eye - before.eye), 1e-4f);
  camera.orbit(0, 10);  // stops before the pole
  EXPECT_GT(camera.view().eye.y, before.centre.y + 0.99f * distanceOf(before));
  camera.orbit(0, -20);
  EXPECT_LT(camera.view().eye.y, before.centre.y - 0.99f * distanceOf(before));
}

TEST(CameraController, PanFlyLookAndZoom) {
  CameraController camera = controller();
  const View before = camera.view();
  camera.pan(0.5f, -0.25f);
  EXPECT_LT(glm::length((camera.view().eye - before.eye) - (camera.view().centre - before.centre)), 1e-5f);
  EXPECT_NEAR(glm::dot(camera.view().eye - before.eye, before.eye - before.centre), 0, 1e-4f);
  camera = controller();
  camera.fly({0, 0, 1}, 1);
  EXPECT_NEAR(glm::dot(glm::normalize(camera.view().eye - before.eye), glm::normalize(before.centre - before.eye)), 1,
              1e-5f);
  camera = controller();
  camera.look(0.3f, 0);
  EXPECT_EQ(camera.view().eye, before.eye);
  EXPECT_NEAR(distanceOf(camera.view()), distanceOf(before), 1e-5f);
  camera = controller();
  camera.zoom(3);
  EXPECT_NEAR(distanceOf(camera.view()), distanceOf(before) * 0.729f, 1e-4f);
  camera.zoom(1e4f);
  EXPECT_GT(distanceOf(camera.view()), 0) << "never into the point itself";
}

TEST(Bindings, KeysAreUnique) {
  const std::vector<std::string> lines = bindingLines();
  EXPECT_GE(lines.size(), 20u);
  for (KeySym key = 'a'; key <= 'z'; ++key) EXPECT_FALSE(actionOf(key) && flightOf(key)) << char(key);
  EXPECT_EQ(actionOf('r'), ViewAction::Reset);
  EXPECT_TRUE(flightOf('w'));
  EXPECT_EQ(dragOf(Button1, 0), Drag::Orbit);
  EXPECT_EQ(dragOf(Button1, ShiftMask | LockMask), Drag::Pan);
  EXPECT_FALSE(dragOf(Button1, ShiftMask | ControlMask));
}

TEST(Playback, GoesRound) {
  Playback playback(2);
  playback.advance(1);
  EXPECT_EQ(playback.seconds(), 0) << "it stands";
  playback.toggle();
  playback.advance(2.5f);
  EXPECT_FLOAT_EQ(playback.seconds(), 0.5f);
  playback.scrub(-1);
  EXPECT_FLOAT_EQ(playback.seconds(), 1.5f);
  EXPECT_FALSE(playback.playing());
  Playback still(0);
  still.toggle();
  still.scrub(1);
  EXPECT_EQ(still.seconds(), 0) << "there is no animation";
}

TEST(Drop, FilesOfUriLists) {
  const struct {
    const char *list, *file;
  } rows[] = {{"file:///tmp/a.glb\r\n", "/tmp/a.glb"},
              {"# comment\r\nfile:///a%20b%C3%A9.gltf\r\nfile:///c\r\n", "/a b\xC3\xA9.gltf"},
              {"file://host.example/d", "/d"},
              {"file:/e", "/e"},
              {"http://a/b.glb", ""},
              {"file:///100%", "/100%"},
              {"file:///%2", "/%2"},
              {"file:///%zz", "/%zz"},
              {"file://", ""},
              {"", ""}};
  for (const auto &[list, file] : rows) EXPECT_EQ(fileOfUriList(list).value_or(""), file) << list;
}

TEST(FileWatch, TellsAChangeOnce) {
  const std::string name = testing::TempDir() + "raycore-watch";
  std::ofstream(name) << "a";
  FileWatch watch;
  watch.watch(name);
  const auto looks = [&] {
    int changes = 0;
    for (int i = 0; i < 60; ++i) {
      changes += watch.changed();
      std::this_thread::sleep_for(std::chrono::milliseconds(15));
    }
    return changes;
  };
  EXPECT_EQ(looks(), 0);
  std::ofstream(name) << "longer";
  EXPECT_EQ(looks(), 1);
  std::filesystem::remove(name);
  EXPECT_EQ(looks(), 0) << "a file that is gone is no new one";
}

}  // namespace
}  // namespace rc::tool
