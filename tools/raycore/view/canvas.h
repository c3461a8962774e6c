// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// canvas.h: the picture of the window as it comes together from passes.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rc::tool {

class Canvas {
 public:
  void resize(int width, int height);
  // A picture with fewer pixels, scaled up.
  void showCoarse(const Image &image);
  // Rows of the full picture from `row` on, counted from the lowest: the mean of this sample and those before.
  void addRows(const Image &rows, int row, int sample);

  const Image &image() const { return mImage; }

 private:
  Image mImage;
  std::vector<uint16_t> mSums;  // by channel
};

// Where in its pixel a sample lies: 0 at the corner, as in pictures with one sample, the others spread evenly.
// [Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018]
Vec2 samplePlace(int sample);

}  // namespace rc::tool
