// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// input.h: a fuzzer's bytes as numbers. One byte names most values that matter, hostile ones among them; an escape
// brings any bit pattern. Behind the end everything is 0, so that each prefix of an input is an input.
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <climits>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace rc::fuzz {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

// What numbers go wrong at.
inline constexpr std::array kWildFloats{
    kNan,   kInf,  -kInf,  -0.0f, FLT_MAX,    -FLT_MAX, FLT_MIN,     1e-45f,        -1e-40f,       1e30f,
    -1e30f, 1e19f, 1e-30f, 1e-7f, 0.3333333f, 1e6f,     16777216.0f, 2147483648.0f, 4294967296.0f, 1e12f};
inline constexpr std::array kWildIntegers{INT_MIN, INT_MIN + 1, INT_MAX, INT_MAX - 1, 0x10000, -0x10000, 1 << 30, 128,
                                          255,     256,         257,     512,         1023,    1024,     1025,    2048,
                                          4096,    16384,       16385,   32767,       32768,   65535,    1 << 20};

class Input {
 public:
  // Codes of integer() and number() behind the plain values.
  static constexpr int kLeastPlain = -64, kMostPlain = 127;
  static constexpr int kPlainFloats = 192, kFloatOrigin = 96;  // (code - origin) / 8
  static constexpr float kFloatStep = 0.125f;
  static constexpr uint8_t kAnyFloat = 255, kAnyInteger = 255, kShortInteger = 254;
  static constexpr uint16_t kAnyToken = 0xffff;

  Input(const uint8_t *data, size_t size) : mData(data), mLeft(size) {}

  bool empty() const { return mLeft == 0; }
  const uint8_t *data() const { return mData; }
  size_t left() const { return mLeft; }

  template <class T>
  T raw() {
    T value{};
    const size_t size = std::min(sizeof value, mLeft);
    if (size > 0) std::memcpy(static_cast<void *>(&value), mData, size);
    mData += size;
    mLeft -= size;
    return value;
  }
  uint8_t byte() { return raw<uint8_t>(); }
  bool flag() { return byte() & 1; }
  // n up to 65536.
  size_t below(size_t n) { return (n <= 256 ? size_t(byte()) : size_t(raw<uint16_t>())) % n; }
  template <class Items>
  auto &oneOf(Items &items) {
    return items[below(std::size(items))];
  }

  int32_t integer() {
    const int code = byte();
    if (code == kAnyInteger) return raw<int32_t>();
    if (code == kShortInteger) return raw<uint16_t>();
    const int plain = code + kLeastPlain;
    if (plain <= kMostPlain) return plain;
    return kWildIntegers[size_t(plain - kMostPlain - 1) % kWildIntegers.size()];
  }
  float number() {
    const int code = byte();
    if (code == kAnyFloat) return raw<float>();
    if (code < kPlainFloats) return kFloatStep * float(code - kFloatOrigin);
    return kWildFloats[size_t(code - kPlainFloats) % kWildFloats.size()];
  }
  // A token, a name, a count: most fit into 16 bits.
  uint32_t token() {
    const auto value = raw<uint16_t>();
    return value == kAnyToken ? raw<uint32_t>() : value;
  }

 private:
  const uint8_t *mData;
  size_t mLeft;
};

// Numbers that follow from a seed in the input: for arrays that are longer than what was given.
class Spread {
 public:
  explicit Spread(uint32_t seed) : mState(seed * 2654435769u + 1) {}
  uint32_t next() {
    mState ^= mState << 13;
    mState ^= mState >> 17;
    mState ^= mState << 5;
    return mState;
  }
  // -1 ... 1
  float unit() { return float(next() >> 8) * 0x2p-24f - 1; }

 private:
  uint32_t mState;
};

// What a target does with an input.
void run(Input in);

}  // namespace rc::fuzz
