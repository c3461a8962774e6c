// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// playback.h: the moment of an animation that runs, stands, or is scrubbed.
#pragma once

#include <cmath>

namespace rc::tool {

class Playback {
 public:
  explicit Playback(float duration = 0) : mDuration(duration) {}

  bool playing() const { return mPlaying; }
  float seconds() const { return mSeconds; }
  float duration() const { return mDuration; }
  void toggle() { mPlaying = mDuration > 0 && !mPlaying; }
  void advance(float seconds) {
    if (mPlaying) move(seconds);
  }
  // Stands still afterwards.
  void scrub(float seconds) {
    mPlaying = false;
    if (mDuration > 0) move(seconds);
  }

 private:
  // Round and round.
  void move(float seconds) { mSeconds = mSeconds + seconds - mDuration * std::floor((mSeconds + seconds) / mDuration); }

  float mDuration, mSeconds = 0;
  bool mPlaying = false;
};

}  // namespace rc::tool
