// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// text.h: text into pictures: legends, and what a window says over its picture.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rc::tool {

inline constexpr int kLetterWidth = 6, kLetterHeight = 13;

using Colour = std::array<uint8_t, 3>;

// Printable ASCII; other bytes become '?'. What lies beside the picture is left out.
void drawText(Image &image, int x, int y, const std::string &text, const Colour &colour);

// A rectangle, mixed with what is there. share: 0 ... 1 of the colour.
void fillBox(Image &image, int x, int y, int width, int height, const Colour &colour, float share = 1);

// Lines on a darkened box whose upper left corner is (x, y).
void drawPanel(Image &image, int x, int y, const std::vector<std::string> &lines);

// Width and height of that box.
std::array<int, 2> panelSize(const std::vector<std::string> &lines);

}  // namespace rc::tool
