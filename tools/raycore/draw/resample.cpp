// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/resample.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rc::tool {
namespace {

constexpr int kSmallest = 16, kLargest = 8192;

struct Tap {
  int index;
  float weight;
};

// For each of `to` places, what it takes of `from` ones.
std::vector<std::vector<Tap>> tapsFor(int from, int to) {
  std::vector<std::vector<Tap>> taps(static_cast<size_t>(to));
  const float scale = float(from) / float(to), reach = std::max(scale, 1.0f);
  for (int i = 0; i < to; ++i) {
    const float centre = (float(i) + 0.5f) * scale - 0.5f;
    float sum = 0;
    std::vector<Tap> &mine = taps[size_t(i)];
    for (int k = int(std::ceil(centre - reach)); k <= int(std::floor(centre + reach)); ++k) {
      const float weight = 1 - std::abs(float(k) - centre) / reach;
      if (weight <= 0) continue;
      mine.push_back({std::clamp(k, 0, from - 1), weight});
      sum += weight;
    }
    for (Tap &tap : mine) tap.weight /= sum;
  }
  return taps;
}

}  // namespace

bool isDeviceSize(int side) { return side >= kSmallest && side <= kLargest && std::has_single_bit(unsigned(side)); }

int deviceSize(int side) {
  return std::clamp(static_cast<int>(std::bit_ceil(unsigned(std::max(side, 1)))), kSmallest, kLargest);
}

Image resampled(const Image &image, int width, int height) {
  const auto columns = tapsFor(image.width, width), rows = tapsFor(image.height, height);
  std::vector<float> wide(size_t(width) * size_t(image.height) * 4);
  for (size_t y = 0; y < size_t(image.height); ++y) {
    for (size_t x = 0; x < size_t(width); ++x) {
      for (const Tap &tap : columns[x]) {
        const uint8_t *from = &image.rgba[(y * size_t(image.width) + size_t(tap.index)) * 4];
        for (size_t c = 0; c < 4; ++c) wide[(y * size_t(width) + x) * 4 + c] += tap.weight * from[c];
      }
    }
  }
  Image result{image.name, width, height, std::vector<uint8_t>(size_t(width) * size_t(height) * 4)};
  const size_t line = size_t(width) * 4;
  for (size_t y = 0; y < size_t(height); ++y) {
    for (size_t x = 0; x < line; ++x) {
      float sum = 0.5f;
      for (const Tap &tap : rows[y]) sum += tap.weight * wide[size_t(tap.index) * line + x];
      result.rgba[y * line + x] = static_cast<uint8_t>(std::min(sum, 255.0f));
    }
  }
  return result;
}

Image forDevice(const Image &image) {
  if (isDeviceSize(image.width) && isDeviceSize(image.height)) return image;
  return resampled(image, deviceSize(image.width), deviceSize(image.height));
}

}  // namespace rc::tool
