// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// float_mode.h: how the processor computes with floats while the library works, whatever the program has set: rounded
// to nearest, denormal numbers as they are, no traps. So pictures do not depend on it, and it is the program's again
// afterwards, sticky flags included.
#pragma once

#include <cstdint>

#if defined(__SSE__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace rc {

#if defined(__SSE__)
class FloatMode {
 public:
  FloatMode() {
    if ((mOutside & ~kFlags) != kDefault) _mm_setcsr(kDefault);
  }
  ~FloatMode() { _mm_setcsr(mOutside); }
  FloatMode(const FloatMode &) = delete;
  FloatMode &operator=(const FloatMode &) = delete;

 private:
  static constexpr uint32_t kFlags = 0x3f, kDefault = 0x1f80;  // [Intel SDM 1, 10.2.3]
  uint32_t mOutside = _mm_getcsr();
};
#else
class FloatMode {
 public:
  FloatMode() {
    std::fegetenv(&mOutside);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatMode() { std::fesetenv(&mOutside); }
  FloatMode(const FloatMode &) = delete;
  FloatMode &operator=(const FloatMode &) = delete;

 private:
  std::fenv_t mOutside;
};
#endif

}  // namespace rc
