// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vertex_fetch.h: elements of client arrays, of any type, as vectors. [spec 3.6]
#pragma once

#include <cstring>

#include "rcddk/geometry.h"

namespace rc::ddk {

template <class T>
T load(const std::byte *at) {
  T value;
  std::memcpy(&value, at, sizeof value);  // client memory need not be aligned
  return value;
}

// The i-th component of an element, as a plain number.
inline float component(const ArrayView &array, size_t element, size_t i) {
  const std::byte *at = array.data + element * array.stride;
  switch (array.type) {
    case Component::Byte:
      return load<int8_t>(at + i);
    case Component::UnsignedByte:
      return load<uint8_t>(at + i);
    case Component::Short:
      return load<int16_t>(at + 2 * i);
    case Component::UnsignedShort:
      return load<uint16_t>(at + 2 * i);
    case Component::UnsignedInt:
      return static_cast<float>(load<uint32_t>(at + 4 * i));
    case Component::Fixed:
      return static_cast<float>(load<int32_t>(at + 4 * i)) / 65536;
    case Component::Float:
      break;
  }
  return load<float>(at + 4 * i);
}

// Not inlined, so that loops over floats, which most arrays hold, stay small.
[[gnu::noinline]] inline Vec3 convertedVec3(const ArrayView &array, size_t element) {
  return {component(array, element, 0), component(array, element, 1), component(array, element, 2)};
}

// Floats come in one piece.
inline Vec3 loadVec3(const ArrayView &array, size_t element) {
  if (array.type == Component::Float) return load<Vec3>(array.data + element * array.stride);
  return convertedVec3(array, element);
}

inline Vec2 loadVec2(const ArrayView &array, size_t element) {
  if (array.type == Component::Float) return load<Vec2>(array.data + element * array.stride);
  return {component(array, element, 0), component(array, element, 1)};
}

// Integers of colours mean 0 ... 1; signed ones by (2 c + 1) / (2^b - 1), as in GL.
inline Rgb loadColor(const ArrayView &array, size_t element) {
  const Vec3 plain = loadVec3(array, element);
  switch (array.type) {
    case Component::Byte:
      return (2.0f * plain + 1.0f) / 255.0f;
    case Component::UnsignedByte:
      return plain / 255.0f;
    case Component::Short:
      return (2.0f * plain + 1.0f) / 65535.0f;
    case Component::UnsignedShort:
      return plain / 65535.0f;
    default:
      return plain;
  }
}

inline size_t loadIndex(const IndexView &indices, size_t i) {
  switch (indices.type) {
    case IndexType::Byte:
      return load<uint8_t>(indices.data + i);
    case IndexType::Short:
      return load<uint16_t>(indices.data + 2 * i);
    case IndexType::Int:
      return load<uint32_t>(indices.data + 4 * i);
    case IndexType::Sequence:
      break;
  }
  return indices.first + i;
}

}  // namespace rc::ddk
