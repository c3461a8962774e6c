// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pictures.h: small pictures for textures, computed from formulas: 8-bit RGB, the first row at the bottom.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

struct Picture {
  int width, height;
  std::vector<uint8_t> rgb;

  // colour(u, v, out): out[0 ... 2] are 0 ... 1.
  template <class Colour>
  Picture(int w, int h, Colour &&colour) : width(w), height(h) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        float out[3];
        colour((float(x) + 0.5f) / float(w), (float(y) + 0.5f) / float(h), out);
        for (float c : out) rgb.push_back(uint8_t(std::clamp(c, 0.0f, 1.0f) * 255));
      }
    }
  }
};

// A fixed pseudo-random number, 0 ... 1, for each point of a grid.
inline float gridNoise(int x, int y) {
  uint32_t h = uint32_t(x) * 0x9E3779B1u ^ uint32_t(y) * 0x85EBCA77u;
  h ^= h >> 15, h *= 0x2C1B3C6Du, h ^= h >> 12, h *= 0x297A2D39u, h ^= h >> 15;
  return float(h & 0xffff) / 65535;
}

// Smooth noise, 0 ... 1, that repeats after `period` cells.
inline float smoothNoise(float x, float y, int period) {
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  const float fx = x - float(x0), fy = y - float(y0);
  const auto at = [&](int i, int j) {
    return gridNoise((i % period + period) % period, (j % period + period) % period);
  };
  const auto mix = [](float a, float b, float t) { return a + (b - a) * t * t * (3 - 2 * t); };
  return mix(mix(at(x0, y0), at(x0 + 1, y0), fx), mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
}

// Noise of several scales, 0 ... 1, seamless over 0 ... 1 in u and v.
inline float cloudNoise(float u, float v, int cells) {
  float sum = 0, weight = 0.5f;
  for (int octave = 0; octave < 5; ++octave, cells *= 2, weight /= 2) {
    sum += weight * smoothNoise(u * float(cells), v * float(cells), cells);
  }
  return sum;
}
