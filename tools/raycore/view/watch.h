// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// watch.h: whether a file changed on disk. Asked for now and then: that works on every file system, and for files that
// are replaced by renaming.
#pragma once

#include <array>
#include <chrono>
#include <string>

namespace rc::tool {

class FileWatch {
 public:
  void watch(const std::string &file);
  // True once after a change, when the file has stayed as it is for two looks: a program that writes it has done so.
  bool changed();

 private:
  using Look = std::array<long long, 4>;  // number of its place on the device, size, seconds, nanoseconds
  static Look lookAt(const std::string &file);

  std::string mFile;
  Look mKnown{}, mLast{};
  std::chrono::steady_clock::time_point mNext;
};

}  // namespace rc::tool
