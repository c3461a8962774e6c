// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace rc::tool {

Progress::Progress(int total, bool quiet)
    : mShown(!quiet && isatty(STDERR_FILENO)), mTotal(total), mStart(std::chrono::steady_clock::now()) {
  if (mShown) fmt::print(stderr, "\rframe 0 of {}", mTotal);
}

Progress::~Progress() {
  if (mShown) fmt::print(stderr, "\r\x1b[K");
}

void Progress::done(int frames, long long rays, double seconds) {
  if (!mShown) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - mStart).count();
  const double left = elapsed / frames * (mTotal - frames);
  fmt::print(stderr, "\r\x1b[Kframe {} of {}, {:.2f} Mrays/s, {:.0f} s left", frames, mTotal,
             seconds > 0 ? double(rays) / seconds / 1e6 : 0.0, left);
}

}  // namespace rc::tool
