// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/watch.h"

#include <sys/stat.h>

namespace rc::tool {
namespace {

constexpr std::chrono::milliseconds kPause{200};

}  // namespace

FileWatch::Look FileWatch::lookAt(const std::string &file) {
  struct stat about {};
  if (stat(file.c_str(), &about) != 0) return {};
  return {static_cast<long long>(about.st_ino), about.st_size, about.st_mtim.tv_sec, about.st_mtim.tv_nsec};
}

void FileWatch::watch(const std::string &file) {
  mFile = file;
  mKnown = mLast = lookAt(file);
  mNext = std::chrono::steady_clock::now() + kPause;
}

bool FileWatch::changed() {
  const auto now = std::chrono::steady_clock::now();
  if (mFile.empty() || now < mNext) return false;
  mNext = now + kPause;
  const Look look = lookAt(mFile);
  const bool steady = look == mLast;
  mLast = look;
  if (!steady || look == mKnown || look == Look{}) return false;
  mKnown = look;
  return true;
}

}  // namespace rc::tool
