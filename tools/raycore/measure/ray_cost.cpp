// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "measure/ray_cost.h"

#include <RC/rc.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "output/text.h"

namespace rc::tool {
namespace {

// Viridis: even steps for the eye, also in grey. [van der Walt, Smith 2015]
constexpr std::array<Colour, 9> kRamp{Colour{68, 1, 84}, {71, 45, 123}, {59, 82, 139},  {44, 114, 142}, {33, 145, 140},
                                      {40, 174, 128},    {94, 201, 98}, {173, 220, 48}, {253, 231, 37}};
constexpr Colour kPaper{255, 255, 255}, kInk{20, 20, 20};
constexpr int kMargin = 8, kBar = 14, kTick = 4, kTicks = 5;
constexpr int kLegend = 3 * kMargin + kBar + kTick + 3 * kLetterHeight;
constexpr int kNarrowest = 330;  // so that the legend's words have room

Colour colourOf(float share) {
  const float place = std::clamp(share, 0.0f, 1.0f) * float(kRamp.size() - 1);
  const size_t first = std::min(size_t(place), kRamp.size() - 2);
  Colour colour{};
  for (size_t c = 0; c < 3; ++c) {
    const float a = kRamp[first][c], b = kRamp[first + 1][c];
    colour[c] = uint8_t(std::lround(a + (b - a) * (place - float(first))));
  }
  return colour;
}

// 1, 2 or 5 times a power of ten, times the number of ticks: their labels are whole numbers.
float endOfScale(float most) {
  const float each = std::max(most / (kTicks - 1), 1.0f), power = std::pow(10.0f, std::floor(std::log10(each)));
  for (const float digit : {1.0f, 2.0f, 5.0f}) {
    if (digit * power >= each) return digit * power * (kTicks - 1);
  }
  return 10 * power * (kTicks - 1);
}

// So few pixels cost more that they would darken all others.
float highEnd(std::vector<float> values) {
  const auto place = values.begin() + std::ptrdiff_t(double(values.size() - 1) * 0.999);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

void drawLegend(Image &image, int top, float end, const std::array<std::string, 2> &words) {
  const int left = kMargin, width = image.width - 2 * kMargin;
  for (int i = 0; i < 2; ++i) drawText(image, left, top + kMargin + i * kLetterHeight, words[size_t(i)], kInk);
  const int bar = top + kMargin + 2 * kLetterHeight + kMargin / 2;
  for (int x = 0; x < width; ++x) fillBox(image, left + x, bar, 1, kBar, colourOf(float(x) / float(width - 1)));
  for (int tick = 0; tick < kTicks; ++tick) {
    const int x = left + tick * (width - 1) / (kTicks - 1);
    fillBox(image, x, bar + kBar, 1, kTick, kInk);
    const bool last = tick == kTicks - 1;
    const std::string label = fmt::format("{:.0f}{}", end * float(tick) / (kTicks - 1), last ? " or more" : "");
    const int size = static_cast<int>(label.size()) * kLetterWidth;
    const int from = std::clamp(x - size / 2, left, left + width - size);
    drawText(image, from, bar + kBar + kTick + 2, label, kInk);
  }
}

}  // namespace

RayCosts rayCosts(const Show &show) {
  const int width = show.settings().width, height = show.settings().height;
  const size_t pixels = size_t(width) * size_t(height);
  RayCosts costs{width, height, std::vector<float>(pixels), std::vector<float>(pixels)};
  rcReadRaysRCX(0, 0, width, height, RC_RAY_BOXES, costs.boxes.data());
  rcReadRaysRCX(0, 0, width, height, RC_RAY_TRIANGLES, costs.triangles.data());
  checkErrors("asking for the cost of rays");
  return costs;
}

double meanOf(const std::vector<float> &values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(std::max<size_t>(values.size(), 1));
}

Image heatMap(const RayCosts &costs) {
  std::vector<float> tests(costs.boxes.size());
  for (size_t i = 0; i < tests.size(); ++i) tests[i] = costs.boxes[i] + costs.triangles[i];
  const float end = endOfScale(highEnd(tests));
  const int width = std::max(costs.width, kNarrowest);
  Image image{"heat map", width, costs.height + kLegend,
              std::vector<uint8_t>(size_t(width) * size_t(costs.height + kLegend) * 4, 255)};
  fillBox(image, 0, 0, image.width, image.height, kPaper);
  for (int y = 0; y < costs.height; ++y) {
    for (int x = 0; x < costs.width; ++x) {
      const float test = tests[size_t(costs.height - 1 - y) * size_t(costs.width) + size_t(x)];
      fillBox(image, x, y, 1, 1, colourOf(test / end));
    }
  }
  const std::array words{std::string("tests of boxes and triangles for a primary ray"),
                         fmt::format("on average {:.1f} + {:.1f}, together {:.0f} at most", meanOf(costs.boxes),
                                     meanOf(costs.triangles), *std::max_element(tests.begin(), tests.end()))};
  drawLegend(image, costs.height, end, words);
  return image;
}

}  // namespace rc::tool
