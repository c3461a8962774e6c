// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// How near pictures of a checkered floor come to one of 256 samples a pixel, on the floor up to the horizon and in a
// mirror ball above it: without mip levels, with them, and with more samples. Decibels, and milliseconds a frame.
#include <RC/rc.h>
#include <RC/rcu.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/stopwatch.h"
#include "frames/offscreen.h"

namespace {

using rc::bench::Offscreen;

constexpr int kWidth = 320, kHeight = 192, kFiner = 16;  // 256 pixels of the finer picture are one of the picture

using Pixels = std::vector<unsigned char>;  // RGBA, from the lower left

struct Way {
  const char *name;
  RCenum mipmaps;  // RC_MIPMAP_HINT
  RCint minFilter;
  RCenum rendering;  // RC_RENDERING_HINT
  RCint anisotropy = 1;

  bool several() const { return rendering == RC_NICEST || rendering == RC_FASTEST_AND_NICEST; }
};
constexpr Way kWays[] = {
    {"level 0, one sample", RC_NICEST, RC_LINEAR, RC_DONT_CARE},
    {"nearest level, one sample", RC_DONT_CARE, RC_LINEAR_MIPMAP_NEAREST, RC_DONT_CARE},
    {"between levels, one sample", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_DONT_CARE},
    {"between levels, two side by side", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_DONT_CARE, 2},
    {"between levels, four side by side", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_DONT_CARE, 4},
    {"between levels, sixteen side by side", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_DONT_CARE, 16},
    {"level 0, four samples (NICEST)", RC_NICEST, RC_LINEAR, RC_NICEST},
    {"between levels, four samples at edges (FASTEST_AND_NICEST)", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR,
     RC_FASTEST_AND_NICEST},
    {"between levels, four samples (NICEST)", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_NICEST},
    {"between levels, sixteen side by side, four samples (NICEST)", RC_DONT_CARE, RC_LINEAR_MIPMAP_LINEAR, RC_NICEST,
     16}};

// Triangles of 2 n^2.
std::vector<float> unitBall(int n) {
  std::vector<float> vertices;
  const auto add = [&](int i, int j) {
    const float a = 3.14159265f * float(i) / float(n), b = 6.2831853f * float(j) / float(n);
    vertices.insert(vertices.end(), {std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)});
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (const auto &[di, dj] : {std::pair{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) add(i + di, j + dj);
    }
  }
  return vertices;
}

class Floor {
 public:
  Floor(int width, int height) : mScreen(width, height) { setUp(); }

  // Milliseconds of a frame.
  double draw(const Way &way) {
    rcBindMaterial(mChecker);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, way.minFilter);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MAX_ANISOTROPY_EXT, way.anisotropy);
    rcHint(RC_MIPMAP_HINT, way.mipmaps);
    rcHint(RC_RENDERING_HINT, way.rendering);
    double best = 1e9;
    for (int frame = 0; frame < 3; ++frame) {
      const rc::Stopwatch watch;
      rcClear(RC_COLOR_BUFFER_BIT);
      drawFloor();
      drawBall();
      rcFinish();
      best = std::min(best, watch.milliseconds());
    }
    return best;
  }
  const Offscreen &screen() const { return mScreen; }

 private:
  void setUp() {
    rcDisable(RC_LIGHTING);
    rcClearColor(0.5f, 0.5f, 0.5f, 1);
    rcuPerspective(60, float(kWidth) / float(kHeight), 0.01f, 10000);
    rcuLookAt(0, 2, 6, 0, 1.6f, 0, 0, 1, 0);
    RCuint names[2];
    rcGenMaterials(2, names);
    mChecker = names[0];
    mMirror = names[1];
    rcBindMaterial(mMirror);
    const std::array black{0.0f, 0.0f, 0.0f, 1.0f}, most{0.9f, 0.9f, 0.9f, 1.0f};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, black.data());
    rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, most.data());
    rcBindMaterial(mChecker);
    RCuint texture = 0;
    rcGenTextures(1, &texture);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, texture);
    constexpr int kTexels = 256;
    Pixels image;
    for (int y = 0; y < kTexels; ++y) {
      for (int x = 0; x < kTexels; ++x) {
        const auto value = static_cast<unsigned char>((x / 32 + y / 32) % 2 ? 230 : 25);
        image.insert(image.end(), {value, value, value, 255});
      }
    }
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, kTexels, kTexels, 0, RC_RGBA, RC_UNSIGNED_BYTE, image.data());
  }

  void drawFloor() const {
    constexpr float kFar = 400, kTiles = 100;
    static const float vertices[] = {-kFar, 0, kFar, kFar, 0, kFar, kFar, 0, -kFar, -kFar, 0, -kFar};
    static const float coordinates[] = {0, 0, kTiles, 0, kTiles, kTiles, 0, kTiles};
    rcBindMaterial(mChecker);
    rcEnable(RC_USE_TEXTURE_ONLY);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, coordinates);
    rcDrawArrays(RC_TRIANGLE_FAN, 0, 4);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    rcDisable(RC_USE_TEXTURE_ONLY);
  }

  void drawBall() const {
    rcBindMaterial(mMirror);
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcNormalPointer(RC_FLOAT, 0, mBall.data());
    rcVertexPointer(3, RC_FLOAT, 0, mBall.data());
    rcMatrixMode(RC_MODELVIEW);
    rcPushMatrix();
    rcTranslatef(0, 2.2f, 2);
    rcEnable(RC_NORMALIZE);
    rcScalef(1.2f, 1.2f, 1.2f);
    rcDrawArrays(RC_TRIANGLES, 0, RCsizei(mBall.size() / 3));
    rcPopMatrix();
    rcDisableClientState(RC_NORMAL_ARRAY);
  }

  Offscreen mScreen;
  RCuint mChecker = 0, mMirror = 0;
  std::vector<float> mBall = unitBall(96);
};

// Means of kFiner x kFiner pixels: of a pixel's square, where several samples lie, or about its lower left corner,
// where a single one does.
std::vector<double> reduced(const Pixels &fine, bool aboutCorners) {
  const int shift = aboutCorners ? kFiner / 2 : 0;
  std::vector<double> sums(size_t(kWidth) * kHeight * 3);
  const auto inside = [&](int i, int count) { return size_t(std::clamp(i - shift, 0, count * kFiner - 1)); };
  for (int y = 0; y < kHeight * kFiner; ++y) {
    for (int x = 0; x < kWidth * kFiner; ++x) {
      const size_t from = (inside(y, kHeight) * kWidth * kFiner + inside(x, kWidth)) * 4;
      for (size_t c = 0; c < 3; ++c) sums[size_t(y / kFiner * kWidth + x / kFiner) * 3 + c] += fine[from + c];
    }
  }
  for (double &sum : sums) sum /= kFiner * kFiner;
  return sums;
}

// Peak signal to noise ratio in decibels, inside or outside the circle that the ball is seen in.
double psnr(const Pixels &pixels, const std::vector<double> &truth, bool ball) {
  double sum = 0, count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double dx = x - 160, dy = y - 120;
      const bool inside = dx * dx + dy * dy < 45 * 45;
      if (inside != ball) continue;
      for (int c = 0; c < 3; ++c) {
        const auto i = size_t(y) * kWidth + size_t(x);
        const double difference = pixels[i * 4 + size_t(c)] - truth[i * 3 + size_t(c)];
        sum += difference * difference;
        ++count;
      }
    }
  }
  return 10 * std::log10(255.0 * 255.0 * count / sum);
}

}  // namespace

int main(int argc, char **argv) {
  std::vector<double> ofSquares, aboutCorners;
  {
    Floor fine(kWidth * kFiner, kHeight * kFiner);
    fine.draw(kWays[0]);
    ofSquares = reduced(fine.screen().pixels(), false);
    aboutCorners = reduced(fine.screen().pixels(), true);
  }
  Floor floor(kWidth, kHeight);
  std::printf("| texture and samples | floor, dB | in the ball, dB | ms |\n|---|---:|---:|---:|\n");
  for (size_t i = 0; i < std::size(kWays); ++i) {
    const double time = floor.draw(kWays[i]);
    const Pixels pixels = floor.screen().pixels();
    const std::vector<double> &truth = kWays[i].several() ? ofSquares : aboutCorners;
    std::printf("| %s | %.1f | %.1f | %.2f |\n", kWays[i].name, psnr(pixels, truth, false), psnr(pixels, truth, true),
                time);
    if (argc > 1) floor.screen().save(std::string(argv[1]) + "/shimmer" + std::to_string(i) + ".ppm");
  }
}
