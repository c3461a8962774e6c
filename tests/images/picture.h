// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// picture.h: pictures in tests: read, warp, compare.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rc::test {

using Pixel = std::array<double, 3>;  // R, G, B, 0 ... 255

struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  // the top row first

  bool empty() const { return width == 0; }
  Pixel at(int x, int y) const;
};

// Empty if the file is no PNG that can be read.
Picture readPng(const std::string &name);

// Where the edges of a window's columns and rows lie in a figure: tx + sx * column, ty + sy * row from the top.
struct Map {
  double tx = 0, ty = 0, sx = 1, sy = 1;
};

// The window as a figure shows it: triangle kernel, widened where the figure is smaller, edges clamped.
struct Warped {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  const Pixel &at(int x, int y) const { return pixels[size_t(y) * size_t(width) + size_t(x)]; }
};
Warped warp(const Picture &window, const Map &map, int width, int height);

struct Difference {
  double mae = 0, psnr = 0;  // three channels together; psnr in dB
};
// Over the pixels for which use(x, y) is true.
Difference compare(const Warped &ours, const Picture &figure, const std::function<bool(int x, int y)> &use);

}  // namespace rc::test
