// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The programs of the guide against the guide's figures, which the real hardware made. The figures are not part
// of the project: RAYCORE_FIGURES names their folder, and without it these tests are skipped.
// Maps, masks, program states and thresholds are those of FIGURES.md in that folder.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "images/run_example.h"

namespace rc::test {
namespace {

struct Rect {
  int x0, x1, y0, y1;  // figure pixels, ends exclusive

  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

struct Figure {
  const char *file;
  const char *example;
  int frame;
  const char *environment;
  const char *arguments;
  Map map;
  std::vector<Rect> masked;
  double maxMae, minPsnr;
};

std::string figuresFolder() {
  const char *folder = std::getenv("RAYCORE_FIGURES");
  return folder ? folder : RAYCORE_FIGURES_DIR;
}

void PrintTo(const Figure &figure, std::ostream *out) { *out << figure.example; }

constexpr const char *kOldLight = "RAYCORE_PROFILE=1000";  // the default light at (0, 0, 1)

const Figure kTriangles[] = {
    {"ch2_perspective.png", "02_5a_perspective", 1, "", "", {}, {}, 0.9, 35},
    {"ch2_frustum.png", "02_5b_frustum", 1, "", "", {}, {}, 0.9, 35},
    {"ch2_lookat.png", "02_5c_look_at", 1, "", "", {}, {}, 0.9, 35},
    {"ch3_translate.png", "03_2a_translate", 1, "", "", {}, {}, 0.9, 35},
    {"ch3_rotate.png", "03_2b_rotate", 1, "", "", {}, {}, 0.9, 35},
    {"ch3_scale.png", "03_2c_scale", 1, "", "", {}, {}, 0.9, 35},
    {"ch3_transform1.png", "03_2d_rotate_then_translate", 1, "", "", {}, {}, 0.9, 35},
    {"ch3_transform2.png", "03_2e_translate_then_rotate", 1, "", "", {}, {}, 0.9, 35},
};

const Figure kScenes[] = {
    {"ch6_phong.png", "06_5a_phong", 1, "", "", {-1, -1, 1, 1}, {}, 0.60, 39.5},
    {"ch6_reflection.png",
     "06_5b_reflection",
     15,
     kOldLight,
     "",
     {-0.059, -0.041, 0.8126, 0.8189},
     {{318, 464, 140, 256}, {240, 298, 168, 226}, {645, 651, 0, 393}},
     1.9,
     35.5},
    {"ch6_refraction.png",
     "06_5c_refraction",
     12,
     kOldLight,
     "",
     {-0.067, -0.998, 0.9111, 0.9124},
     {{238, 496, 122, 320}},
     1.0,
     42},
    {"ch9_cornell.png", "09_4_cornell_box", 15, "", "0.2", {-0.991, -0.861, 0.9125, 0.9099}, {}, 1.7, 37.5},
};

class FigureTest : public testing::TestWithParam<Figure> {
 protected:
  // Fills mFigure and mWarped, or skips.
  void load(const Figure &figure) {
    mFigure = readPng(figuresFolder() + "/" + figure.file);
    if (mFigure.empty()) GTEST_SKIP() << "no figure " << figure.file << " in " << figuresFolder();
    const ExampleRun run = runExample(figure.example, figure.frame, figure.environment, figure.arguments);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    ASSERT_FALSE(run.picture.empty()) << run.output;
    mWarped = warp(run.picture, figure.map, mFigure.width, mFigure.height);
  }

  Picture mFigure;
  Warped mWarped;
};

TEST_P(FigureTest, AgreesWithTheHardware) {
  const Figure &figure = GetParam();
  load(figure);
  if (IsSkipped() || HasFatalFailure()) return;
  const Difference difference = compare(mWarped, mFigure, [&](int x, int y) {
    for (const Rect &rect : figure.masked) {
      if (rect.contains(x, y)) return false;
    }
    return true;
  });
  std::cout << figure.example << ": MAE " << difference.mae << ", PSNR " << difference.psnr << " dB\n";
  EXPECT_LE(difference.mae, figure.maxMae);
  EXPECT_GE(difference.psnr, figure.minPsnr);
}

std::string nameOf(const testing::TestParamInfo<Figure> &info) { return "Example_" + std::string(info.param.example); }

INSTANTIATE_TEST_SUITE_P(Triangles, FigureTest, testing::ValuesIn(kTriangles), nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, FigureTest, testing::ValuesIn(kScenes), nameOf);

using Figures = FigureTest;

TEST_F(Figures, TheTriangleHasTheColoursOfTheFigure) {
  load(kTriangles[0]);
  if (IsSkipped() || HasFatalFailure()) return;
  EXPECT_EQ(mWarped.at(400, 300), (Pixel{255, 255, 0}));
  const Pixel background = mWarped.at(100, 100), expected{186, 51, 58};
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(background[c], expected[c], 2);
}

TEST_F(Figures, HighlightsOfTheBallsAgree) {
  load(kScenes[0]);
  if (IsSkipped() || HasFatalFailure()) return;
  struct Window {
    Rect rect;
    size_t channel;
    double maxMae;
  };
  const Window windows[] = {
      {{243, 293, 205, 255}, 1, 1.5}, {{364, 414, 205, 255}, 2, 2.4}, {{484, 534, 205, 255}, 0, 2.8}};
  for (const Window &window : windows) {
    double sum = 0, count = 0;
    for (int y = window.rect.y0; y < window.rect.y1; ++y) {
      for (int x = window.rect.x0; x < window.rect.x1; ++x, ++count) {
        sum += std::abs(mWarped.at(x, y)[window.channel] - mFigure.at(x, y)[window.channel]);
      }
    }
    std::cout << "highlight in channel " << window.channel << ": MAE " << sum / count << "\n";
    EXPECT_LE(sum / count, window.maxMae);
  }
}

// The textures of the figure are unknown: the outline is compared, filled white.
TEST_F(Figures, TheCubeHasTheOutlineOfTheFigure) {
  load({"appB_cube.png", "b_cube", 13, kOldLight, "figure", {0.625, -0.840, 0.8134, 0.8147}, {}, 0.5, 37});
  if (IsSkipped() || HasFatalFailure()) return;
  const auto inside = [&](int x, int y) {
    const Pixel &pixel = mWarped.at(x, y);
    return std::max({pixel[0], pixel[1], pixel[2]}) > 0;
  };
  // Black texels would look like background; the example's pictures have none.
  ExampleRun run = runExample("b_cube", 13, kOldLight, "figure");
  for (size_t i = 0; i < run.picture.rgb.size(); i += 3) {
    uint8_t *pixel = &run.picture.rgb[i];
    const bool covered = pixel[0] | pixel[1] | pixel[2];
    pixel[0] = pixel[1] = pixel[2] = covered ? 255 : 0;
  }
  const Warped outline = warp(run.picture, {0.625, -0.840, 0.8134, 0.8147}, mFigure.width, mFigure.height);
  Picture brightest = mFigure;
  for (size_t i = 0; i < brightest.rgb.size(); i += 3) {
    uint8_t *pixel = &brightest.rgb[i];
    pixel[0] = pixel[1] = pixel[2] = std::max({pixel[0], pixel[1], pixel[2]});
  }
  const auto nearOutside = [&](int x, int y) {
    for (int dy = -3; dy <= 3; ++dy) {
      for (int dx = -3; dx <= 3; ++dx) {
        if (dx * dx + dy * dy <= 9 && !inside(x + dx, y + dy)) return true;
      }
    }
    return false;
  };
  const Difference difference = compare(outline, brightest, [&](int x, int y) {
    const bool border = x < 3 || y < 3 || x >= mFigure.width - 3 || y >= mFigure.height - 3;
    return !border && !Rect{195, 380, 225, 325}.contains(x, y) && nearOutside(x, y);
  });
  std::cout << "cube outline: MAE " << difference.mae << ", PSNR " << difference.psnr << " dB\n";
  EXPECT_LE(difference.mae, 0.5);
  EXPECT_GE(difference.psnr, 37);
}

// The textures are unknown, but red over the ocean is the highlight and a little diffuse light:
// R = a * highlight + b * (N.L), by least squares.
TEST_F(Figures, TheEarthHasTheHighlightOfTheFigure) {
  const Map map{-0.16, 0.14, 0.9125, 0.9125};
  load({"appC_earth.png", "c_earth", 22, "", "black", map, {}, 0, 0});
  if (IsSkipped() || HasFatalFailure()) return;
  const ExampleRun white = runExample("c_earth", 22, "", "white");
  ASSERT_FALSE(white.picture.empty());
  // Green has no highlight: over white paint it is N.L.
  const Warped diffuse = warp(white.picture, map, mFigure.width, mFigure.height);
  double ss = 0, sd = 0, dd = 0, rs = 0, rd = 0, n = 0;
  std::vector<std::array<double, 3>> samples;
  for (int y = 140; y < 300; ++y) {
    for (int x = 345; x < mFigure.width; ++x) {
      const Pixel theirs = mFigure.at(x, y);
      const double radius = std::hypot(x + 0.5 - 365, y + 0.5 - 219);
      if (radius > 116 || theirs[2] <= 1.5 * theirs[1]) continue;
      const double s = mWarped.at(x, y)[0], d = diffuse.at(x, y)[1] / 255, r = theirs[0];
      samples.push_back({s, d, r});
      ss += s * s, sd += s * d, dd += d * d, rs += r * s, rd += r * d, ++n;
    }
  }
  const double determinant = ss * dd - sd * sd, a = (rs * dd - rd * sd) / determinant,
               b = (rd * ss - rs * sd) / determinant;
  double square = 0;
  for (const auto &[s, d, r] : samples) square += (r - a * s - b * d) * (r - a * s - b * d);
  const double rms = std::sqrt(square / n);
  std::cout << "highlight of the Earth: a " << a << ", b " << b << ", rms " << rms << " over " << n << " pixels\n";
  EXPECT_GE(a, 0.96);
  EXPECT_LE(a, 1.04);
  EXPECT_LE(rms, 4);
  for (int y = 200; y < 240; ++y) {
    for (int x = 256; x < 276; ++x) {
      for (double channel : mWarped.at(x, y)) ASSERT_LE(channel, 2) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace rc::test
