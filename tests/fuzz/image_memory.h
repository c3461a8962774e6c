// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// image_memory.h: images in the caller's memory, of exactly the size that a call may read or write.
#pragma once

#include <memory>

#include "RC/rc.h"
#include "input.h"

namespace rc::fuzz {

inline size_t texelBytes(RCenum format, RCenum type) {
  if (type == RC_UNSIGNED_BYTE || type == RC_BYTE) return format == RC_RGB ? 3 : 4;
  return type == RC_FLOAT ? 16 : 2;
}

// The last row is not filled up to the alignment. [OpenGL ES 1.1, 3.6.1]
inline uint64_t imageBytes(RCsizei width, RCsizei height, size_t texel, RCint alignment) {
  if (width <= 0 || height <= 0) return 0;
  const uint64_t row = uint64_t(width) * texel, unit = uint64_t(alignment);
  return (row + unit - 1) / unit * unit * uint64_t(height - 1) + row;
}

// Memory of that size. What is larger than one_input.cpp allows is never read: the library's copy would be as large.
// Sometimes there is none.
class Pixels {
 public:
  static constexpr uint64_t kMost = 8 << 20;

  Pixels(uint64_t bytes, Input &in) {
    if (in.below(16) == 1) return;
    const size_t size = bytes > kMost ? 1 : size_t(bytes);
    mBytes.reset(new uint8_t[size]);
    Spread random(in.byte());
    const uint8_t fixed = in.byte();
    if (size > 0) std::memset(mBytes.get(), fixed, size);
    if (fixed >= 128) return;
    for (size_t i = 0; i < std::min<size_t>(size, 1 << 14); ++i) mBytes[i] = uint8_t(random.next());
  }
  uint8_t *data() { return mBytes.get(); }

 private:
  std::unique_ptr<uint8_t[]> mBytes;
};

}  // namespace rc::fuzz
