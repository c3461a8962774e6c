// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/refinement.h"

#include <algorithm>
#include <cmath>

namespace rc::tool {
namespace {

constexpr double kFrame = 0.024;  // seconds for tracing in motion: thirty frames a second, and time to show them
constexpr double kStrip = 0.04;   // seconds until a key is answered at rest
constexpr double kSlower = 0.8;   // of the time a frame has: less, and there may be more pixels
constexpr int kCoarsest = 16;
constexpr int kFewestRows = 8;

}  // namespace

void Refinement::resize(int width, int height) {
  mWidth = width;
  mHeight = height;
  restart();
}

void Refinement::restart() {
  mShown = false;
  mSample = mRow = 0;
}

int Refinement::rowsOfStrip() const {
  if (mPixelSeconds <= 0) return std::max(kFewestRows, mHeight / 16);
  const double rows = kStrip / (mPixelSeconds * mWidth);
  return std::max(kFewestRows, static_cast<int>(std::min(rows, double(mHeight))));
}

std::optional<Pass> Refinement::next(bool moving) const {
  const bool coarse = moving || (!mShown && mStep > 1);
  if (coarse && mStep > 1) return Pass{mStep, 0, 0, heightOf(mStep)};
  if (moving) return Pass{1, 0, 0, mHeight};
  if (mSample >= mSamples) return std::nullopt;
  return Pass{1, mSample, mRow, std::min(rowsOfStrip(), mHeight - mRow)};
}

void Refinement::done(const Pass &pass, double seconds) {
  mPixelSeconds = seconds / (double(widthOf(pass.step)) * pass.rows);
  const bool whole = pass.rows == heightOf(pass.step);
  if (whole || !mShown) chooseStep(pass, seconds);
  mShown = true;
  if (pass.step > 1) return;
  mRow = pass.row + pass.rows;
  if (mRow < mHeight) return;
  mRow = 0;
  mSample = pass.sample + 1;
}

// Time goes with the pixels, or grows more slowly: what does not depend on them makes the choice a careful one.
void Refinement::chooseStep(const Pass &pass, double seconds) {
  const double pixels = double(mWidth) * mHeight;
  const auto predicted = [&](int step) { return mPixelSeconds * pixels / (double(step) * step); };
  if (pass.step == mStep && pass.rows == heightOf(pass.step) && seconds <= kFrame &&
      (mStep == 1 || predicted(mStep - 1) > kSlower * kFrame)) {
    return;
  }
  int step = 1;
  while (step < kCoarsest && predicted(step) > kSlower * kFrame) ++step;
  mStep = step;
}

}  // namespace rc::tool
