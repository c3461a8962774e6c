// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/text.h"

#include <algorithm>

namespace rc::tool {
namespace {

constexpr uint8_t kLetters[][kLetterHeight] = {
#include "output/font.inc"
};
static_assert(std::size(kLetters) == '~' - ' ' + 1);

constexpr int kMargin = 6;
constexpr Colour kDark{16, 18, 22}, kLight{235, 238, 240};

uint8_t *pixelOf(Image &image, int x, int y) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return nullptr;
  return &image.rgba[(size_t(y) * size_t(image.width) + size_t(x)) * 4];
}

void drawLetter(Image &image, int x, int y, char letter, const Colour &colour) {
  const char known = letter >= ' ' && letter <= '~' ? letter : '?';
  const uint8_t *rows = kLetters[known - ' '];
  for (int row = 0; row < kLetterHeight; ++row) {
    for (int column = 0; column < kLetterWidth; ++column) {
      uint8_t *pixel = rows[row] >> column & 1 ? pixelOf(image, x + column, y + row) : nullptr;
      if (pixel) std::copy(colour.begin(), colour.end(), pixel);
    }
  }
}

}  // namespace

void drawText(Image &image, int x, int y, const std::string &text, const Colour &colour) {
  for (const char letter : text) {
    drawLetter(image, x, y, letter, colour);
    x += kLetterWidth;
  }
}

void fillBox(Image &image, int x, int y, int width, int height, const Colour &colour, float share) {
  const int part = static_cast<int>(share * 256);
  for (int row = std::max(y, 0); row < std::min(y + height, image.height); ++row) {
    for (int column = std::max(x, 0); column < std::min(x + width, image.width); ++column) {
      uint8_t *pixel = pixelOf(image, column, row);
      for (size_t c = 0; c < 3; ++c) pixel[c] = uint8_t((pixel[c] * (256 - part) + colour[c] * part) / 256);
    }
  }
}

std::array<int, 2> panelSize(const std::vector<std::string> &lines) {
  size_t longest = 0;
  for (const std::string &line : lines) longest = std::max(longest, line.size());
  return {int(longest) * kLetterWidth + 2 * kMargin, int(lines.size()) * kLetterHeight + 2 * kMargin};
}

void drawPanel(Image &image, int x, int y, const std::vector<std::string> &lines) {
  if (lines.empty()) return;
  const auto [width, height] = panelSize(lines);
  fillBox(image, x, y, width, height, kDark, 0.72f);
  for (size_t i = 0; i < lines.size(); ++i) {
    drawText(image, x + kMargin, y + kMargin + int(i) * kLetterHeight, lines[i], kLight);
  }
}

}  // namespace rc::tool
