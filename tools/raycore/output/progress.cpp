// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace rc::tool {

Progress::Progress(const char *what, int total, bool quiet)
    : mShown(!quiet && isatty(STDERR_FILENO)), mWhat(what), mTotal(total), mStart(std::chrono::steady_clock::now()) {
  if (mShown) fmt::print(stderr, "\r{} 0 of {}", mWhat, mTotal);
}

Progress::~Progress() {
  if (mShown) fmt::print(stderr, "\r\x1b[K");
}

void Progress::done(int count, long long rays, double seconds) {
  if (!mShown) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - mStart).count();
  const std::string rate = seconds > 0 ? fmt::format(", {:.2f} Mrays/s", double(rays) / seconds / 1e6) : "";
  fmt::print(stderr, "\r\x1b[K{} {} of {}{}, {:.0f} s left", mWhat, count, mTotal, rate,
             elapsed / count * (mTotal - count));
}

}  // namespace rc::tool
