// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// sequence.h: which frames there are, and the names of their files.
#pragma once

#include <string>

namespace rc::tool {

struct FrameRange {
  int first = 0, last = 0;

  int count() const { return last - first + 1; }
};

// "a-b" or "a". Throws UsageError.
FrameRange rangeFrom(const std::string &text);

// %d or %04d in the pattern becomes the number; without one, -0001 is put before the extension.
std::string fileOfFrame(const std::string &pattern, int frame);

// Whether the name has a place for the number.
bool isNumbered(const std::string &name);

bool isVideo(const std::string &name);

}  // namespace rc::tool
