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
  // what: "frame".
  Progress(const char *what, int total, bool quiet);
  ~Progress();
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  // count of them are done; rays that were traced, in these seconds, if that is known.
  void done(int count, long long rays = 0, double seconds = 0);

 private:
  bool mShown;
  const char *mWhat;
  int mTotal;
  std::chrono::steady_clock::time_point mStart;
};

}  // namespace rc::tool
