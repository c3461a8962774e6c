// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What the glTF sample models say about themselves, checked in the pictures of `raycore render`.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace {

using Pixel = std::array<int, 3>;

struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;

  Pixel at(int x, int y) const {
    const uint8_t *p = &rgb[size_t(y * width + x) * 3];
    return {p[0], p[1], p[2]};
  }
  // x and y: 0 ... 1, from the upper left corner.
  Pixel at(double x, double y) const { return at(int(x * width), int(y * height)); }
};

Picture readPpm(const std::string &name) {
  std::ifstream file(name, std::ios::binary);
  std::string magic;
  int largest = 0;
  Picture picture;
  file >> magic >> picture.width >> picture.height >> largest;
  file.get();
  picture.rgb.resize(size_t(picture.width) * size_t(picture.height) * 3);
  file.read(reinterpret_cast<char *>(picture.rgb.data()), std::streamsize(picture.rgb.size()));
  EXPECT_TRUE(file && magic == "P6" && largest == 255) << name;
  return picture;
}

Picture render(const std::string &model, const std::string &options) {
  const std::string path = std::string(RAYCORE_SCENES_DIR) + "/gltf/" + model;
  const std::string name =
      testing::TempDir() + "pixels-" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".ppm";
  std::filesystem::remove(name);
  const std::string command = std::string(RAYCORE_TOOL) + " render '" + path + "' -q -o '" + name + "' " + options;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return readPpm(name);
}

constexpr int kBackground = 60;  // no channel of the default background is above

bool covered(const Pixel &pixel) { return pixel[0] > kBackground; }

class Pixels : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::string(RAYCORE_SCENES_DIR) + "/gltf"))
      GTEST_SKIP() << "no models in " RAYCORE_SCENES_DIR;
  }
};

void expectColour(const Pixel &pixel, const std::array<bool, 3> &strong) {
  for (size_t c = 0; c < 3; ++c) EXPECT_EQ(pixel[c] > 140, strong[c]) << pixel[0] << ' ' << pixel[1] << ' ' << pixel[2];
}

// "Top Left" is yellow, "Top Right" orange, "Bottom Left" blue, "Bottom Right" green.
TEST_F(Pixels, TextureCoordinateTest) {
  const Picture picture = render("TextureCoordinateTest.glb", "--size 160x120 --angle 0,0 --lights none");
  expectColour(picture.at(.3, .2), {true, true, false});
  expectColour(picture.at(.7, .2), {true, false, false});
  expectColour(picture.at(.3, .8), {false, false, true});
  expectColour(picture.at(.7, .8), {false, true, false});
}

// Offsets that fail show "X"; those of the upper row that work fill their squares with one colour each.
TEST_F(Pixels, TextureTransformTest) {
  const Picture picture =
      render("TextureTransformTest/TextureTransformTest.gltf", "--size 300x240 --angle 0,0 --lights none --samples 1");
  expectColour(picture.at(.1, .1), {false, true, false});
  expectColour(picture.at(.45, .1), {false, false, true});
  expectColour(picture.at(.75, .1), {false, true, true});
}

// Nothing but the two base colours and the background.
TEST_F(Pixels, UnlitTest) {
  const Picture picture = render("UnlitTest.glb", "--size 160x120 --samples 1");
  std::set<Pixel> colours;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) colours.insert(picture.at(x, y));
  }
  EXPECT_EQ(colours.size(), 3u);
  EXPECT_TRUE(colours.contains({255, 128, 0}));
  EXPECT_TRUE(colours.contains({0, 128, 255}));
}

// Each row of spheres has one colour, whether it comes from a factor or from a texture: surfaces, then light of their
// own.
TEST_F(Pixels, TextureEncodingTest) {
  const Picture picture = render("TextureEncodingTest.glb", "--size 310x240 --angle 0,0 --lights none --samples 1");
  for (const double y : {.35, .57}) {
    const Pixel factor = picture.at(.345, y);
    EXPECT_GT(factor[1], 100) << y;
    for (const double x : {.516, .687, .86}) {
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(x, y)[c], factor[c], 3) << x << ' ' << y;
    }
  }
}

int stripedPixels(const Picture &picture, double from, double to) {
  int most = 0;
  for (int x = int(from * picture.width); x < int(to * picture.width); ++x) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y) count += picture.at(x, y)[1] > picture.at(x, y)[0] + 25;
    most = std::max(most, count);
  }
  return most;
}

// The opaque panel is whole; cut-offs of 0.25, 0.5 and 0.75 leave three quarters, a half, and a quarter of it.
TEST_F(Pixels, AlphaBlendModeTest) {
  const Picture picture = render("AlphaBlendModeTest.glb", "--size 800x300 --angle 0,0 --lights none");
  const double whole = stripedPixels(picture, .18, .27);
  ASSERT_GT(whole, 60);
  EXPECT_NEAR(stripedPixels(picture, .47, .555) / whole, .72, .09);
  EXPECT_NEAR(stripedPixels(picture, .62, .685) / whole, .48, .09);
  EXPECT_NEAR(stripedPixels(picture, .77, .83) / whole, .26, .09);
}

// The frame of the box is the same on all sides; the arrows are red towards +x, green towards +y, blue towards +z.
TEST_F(Pixels, OrientationTest) {
  const auto count = [](const Picture &picture, size_t channel) {
    int found = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const Pixel p = picture.at(x, y);
        found += p[channel] > 100 && p[(channel + 1) % 3] < 40 && p[(channel + 2) % 3] < 40;
      }
    }
    return found;
  };
  const std::array<const char *, 3> sides{"--angle 90,0", "--angle 0,89", "--angle 0,0"};
  for (size_t side = 0; side < 3; ++side) {
    const Picture picture = render("OrientationTest.glb", std::string("--size 80x60 --lights none ") + sides[side]);
    for (size_t channel = 0; channel < 3; ++channel) {
      const int seen = count(picture, channel);
      EXPECT_TRUE(channel == side ? seen > 50 : seen < 20) << sides[side] << ": " << seen << " of channel " << channel;
    }
  }
}

// A turn in a second, counter-clockwise about the corner at the origin.
TEST_F(Pixels, AnimatedTriangle) {
  const struct {
    const char *time;
    std::array<bool, 4> quarters;  // upper right, upper left, lower left, lower right
  } moments[] = {{"0", {true, false, false, false}},
                 {"0.25", {false, true, false, false}},
                 {"0.5", {false, false, true, false}},
                 {"0.75", {false, false, false, true}}};
  for (const auto &moment : moments) {
    const Picture picture = render("AnimatedTriangle/AnimatedTriangle.gltf",
                                   std::string("--eye 0,0,4 --look-at 0,0,0 --size 100x100 --time ") + moment.time);
    const std::array<Pixel, 4> seen{picture.at(.57, .43), picture.at(.43, .43), picture.at(.43, .57),
                                    picture.at(.57, .57)};
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(covered(seen[i]), moment.quarters[i]) << moment.time << ' ' << i;
  }
}

// At one second the upper joint has turned by 90 degrees: the strip leans to the left.
TEST_F(Pixels, SimpleSkin) {
  const std::string camera = "--eye 0,1,6 --look-at 0,1,0 --size 100x100 --time ";
  const Picture straight = render("SimpleSkin/SimpleSkin.gltf", camera + "0");
  const Picture bent = render("SimpleSkin/SimpleSkin.gltf", camera + "1");
  EXPECT_TRUE(covered(straight.at(.5, .35)));
  EXPECT_FALSE(covered(straight.at(.33, .45)));
  EXPECT_FALSE(covered(bent.at(.5, .35)));
  EXPECT_TRUE(covered(bent.at(.33, .45)));
}

// The second morph target moves the tip to the left.
TEST_F(Pixels, SimpleMorph) {
  const std::string camera = "--eye 0.5,0.5,4 --look-at 0.5,0.5,0 --size 100x100 --time ";
  const Picture start = render("SimpleMorph/SimpleMorph.gltf", camera + "0");
  const Picture later = render("SimpleMorph/SimpleMorph.gltf", camera + "1");
  EXPECT_NE(start.rgb, later.rgb);
}

}  // namespace
