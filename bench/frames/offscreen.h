// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// offscreen.h: a context that draws into a pbuffer, current on the thread that makes it.
#pragma once

#include <string>
#include <vector>

namespace rc::bench {

// How many threads trace; before the first context, since the library reads RAYCORE_THREADS once.
void useThreads(int threads);

class Offscreen {
 public:
  // Ends the program if there is no context to be had.
  Offscreen(int width, int height);
  ~Offscreen();
  Offscreen(const Offscreen &) = delete;
  Offscreen &operator=(const Offscreen &) = delete;

  int width() const { return mWidth; }
  int height() const { return mHeight; }
  void swap() const;
  void wait() const;                          // for all that was swapped
  std::vector<unsigned char> pixels() const;  // RGBA, from the lower left
  void save(const std::string &path) const;   // as PPM

 private:
  int mWidth, mHeight;
  void *mDisplay = nullptr, *mContext = nullptr, *mSurface = nullptr;
};

}  // namespace rc::bench
