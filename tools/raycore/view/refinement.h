// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// refinement.h: which part of the picture is traced next, so that motion is smooth and rest is sharp.
//
// While something moves, the picture has fewer pixels: a step of n traces one pixel for each n x n. At rest the full
// picture follows in strips of rows, so short that a key is answered at once, and then more samples a pixel.
#pragma once

#include <optional>

namespace rc::tool {

struct Pass {
  int step = 1;
  int sample = 0;         // from 0; of full pictures
  int row = 0, rows = 0;  // of the picture with this step, from the lowest
};

class Refinement {
 public:
  explicit Refinement(int samples) : mSamples(samples) {}

  void resize(int width, int height);
  // Another picture is wanted.
  void restart();
  // Nothing: the picture is done.
  std::optional<Pass> next(bool moving) const;
  // The pass was made, in that time.
  void done(const Pass &pass, double seconds);

  // Samples of which the whole picture consists; 0 while it is coarse.
  int samplesDone() const { return mSample; }
  int samples() const { return mSamples; }
  int step() const { return mStep; }
  int widthOf(int step) const { return mWidth / step > 0 ? mWidth / step : 1; }
  int heightOf(int step) const { return mHeight / step > 0 ? mHeight / step : 1; }

 private:
  int rowsOfStrip() const;
  void chooseStep(const Pass &pass, double seconds);

  int mSamples;
  int mWidth = 1, mHeight = 1;
  int mStep = 1;        // of pictures in motion
  bool mShown = false;  // something of this picture
  int mSample = 0, mRow = 0;
  double mPixelSeconds = 0;  // what a pixel takes, 0: not known
};

}  // namespace rc::tool
