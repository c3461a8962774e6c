// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// progress.h: what a person sees of long work: a line on a terminal, nothing in a pipe.
#pragma once

#include <chrono>
#include <string>

namespace rc::tool {

class Progress {
 public:
  Progress(int total, bool quiet);
  ~Progress();
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  void done(int frames, long long rays, double seconds);

 private:
  bool mShown;
  int mTotal;
  std::chrono::steady_clock::time_point mStart;
};

}  // namespace rc::tool
