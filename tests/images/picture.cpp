// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "images/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc::test {
namespace {

struct Tap {
  int index;
  double weight;
};

// Weights of the window's pixels for one figure pixel along one axis.
std::vector<Tap> taps(int figurePixel, double t, double s, int size) {
  const double centre = (figurePixel + 0.5 - t) / s - 0.5, radius = std::max(1.0, 1 / s);
  std::vector<Tap> result;
  double sum = 0;
  for (int i = int(std::ceil(centre - radius)); i <= int(std::floor(centre + radius)); ++i) {
    const double weight = 1 - std::abs(i - centre) / radius;
    if (weight <= 0) continue;
    result.push_back({std::clamp(i, 0, size - 1), weight});
    sum += weight;
  }
  for (Tap &tap : result) tap.weight /= sum;
  return result;
}

}  // namespace

Pixel Picture::at(int x, int y) const {
  const uint8_t *at = &rgb[3 * (size_t(y) * size_t(width) + size_t(x))];
  return {double(at[0]), double(at[1]), double(at[2])};
}

Picture readPng(const std::string &name) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, name.c_str())) return {};
  image.format = PNG_FORMAT_RGB;
  Picture picture{int(image.width), int(image.height), std::vector<uint8_t>(PNG_IMAGE_SIZE(image))};
  if (!png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr)) return {};
  return picture;
}

Warped warp(const Picture &window, const Map &map, int width, int height) {
  Warped result{width, height, std::vector<Pixel>(size_t(width) * size_t(height))};
  std::vector<std::vector<Tap>> columns;
  for (int x = 0; x < width; ++x) columns.push_back(taps(x, map.tx, map.sx, window.width));
  for (int y = 0; y < height; ++y) {
    const std::vector<Tap> rows = taps(y, map.ty, map.sy, window.height);
    for (int x = 0; x < width; ++x) {
      Pixel &sum = result.pixels[size_t(y) * size_t(width) + size_t(x)];
      for (const Tap &row : rows) {
        for (const Tap &column : columns[size_t(x)]) {
          const Pixel pixel = window.at(column.index, row.index);
          for (size_t c = 0; c < 3; ++c) sum[c] += row.weight * column.weight * pixel[c];
        }
      }
    }
  }
  return result;
}

Difference compare(const Warped &ours, const Picture &figure, const std::function<bool(int x, int y)> &use) {
  double absolute = 0, square = 0, count = 0;
  for (int y = 0; y < figure.height; ++y) {
    for (int x = 0; x < figure.width; ++x) {
      if (!use(x, y)) continue;
      const Pixel theirs = figure.at(x, y);
      for (size_t c = 0; c < 3; ++c) {
        const double d = ours.at(x, y)[c] - theirs[c];
        absolute += std::abs(d);
        square += d * d;
        ++count;
      }
    }
  }
  if (count == 0) return {};
  const double infinite = std::numeric_limits<double>::infinity();
  return {absolute / count, square > 0 ? 10 * std::log10(255 * 255 * count / square) : infinite};
}

}  // namespace rc::test
