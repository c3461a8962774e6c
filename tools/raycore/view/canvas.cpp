// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/canvas.h"

#include <algorithm>
#include <cmath>

namespace rc::tool {
namespace {

// Where a column or row of the large picture lies between two of the small one; share: of 256.
struct Between {
  int first, second, share;
};

std::vector<Between> betweens(int large, int small) {
  std::vector<Between> all(static_cast<size_t>(large));
  for (int i = 0; i < large; ++i) {
    const float at = std::clamp((float(i) + 0.5f) * float(small) / float(large) - 0.5f, 0.0f, float(small - 1));
    const int first = static_cast<int>(at);
    all[size_t(i)] = {first, std::min(first + 1, small - 1), static_cast<int>((at - float(first)) * 256)};
  }
  return all;
}

int mixed(int a, int b, int share) { return a + (b - a) * share / 256; }

}  // namespace

void Canvas::resize(int width, int height) {
  const size_t pixels = size_t(width) * size_t(height);
  mImage = {"", width, height, std::vector<uint8_t>(pixels * 4, 255)};
  mSums.assign(pixels * 4, 0);
}

// Bilinear, a row at a time: first down, then across.
void Canvas::showCoarse(const Image &image) {
  const std::vector<Between> columns = betweens(mImage.width, image.width),
                             rows = betweens(mImage.height, image.height);
  const size_t bytes = size_t(image.width) * 4;
  std::vector<uint8_t> line(bytes);
  for (size_t y = 0; y < rows.size(); ++y) {
    const uint8_t *above = &image.rgba[size_t(rows[y].first) * bytes],
                  *below = &image.rgba[size_t(rows[y].second) * bytes];
    for (size_t i = 0; i < bytes; ++i) line[i] = uint8_t(mixed(above[i], below[i], rows[y].share));
    uint8_t *to = &mImage.rgba[y * columns.size() * 4];
    for (const Between &column : columns) {
      const uint8_t *left = &line[size_t(column.first) * 4], *right = &line[size_t(column.second) * 4];
      for (size_t c = 0; c < 4; ++c) *to++ = uint8_t(mixed(left[c], right[c], column.share));
    }
  }
}

void Canvas::addRows(const Image &rows, int row, int sample) {
  const size_t first = size_t(mImage.height - row - rows.height) * size_t(mImage.width) * 4;
  const int count = sample + 1;
  for (size_t i = 0; i < rows.rgba.size(); ++i) {
    uint16_t &sum = mSums[first + i];
    sum = uint16_t((sample == 0 ? 0 : sum) + rows.rgba[i]);
    mImage.rgba[first + i] = uint8_t((sum + count / 2) / count);
  }
}

Vec2 samplePlace(int sample) {
  const Vec2 place = float(sample) * Vec2(0.7548776662f, 0.5698402910f);
  return place - glm::floor(place);
}

}  // namespace rc::tool
