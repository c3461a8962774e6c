// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// arrays.h: the client arrays by their tokens. [spec 3.6]
#pragma once

#include <optional>

#include "api/state.h"
#include "rcddk/geometry.h"

namespace rc::api {

// How values of a type are read, or nothing for types that arrays cannot have.
inline std::optional<ddk::Component> findComponent(RCenum type) {
  switch (type) {
    case RC_BYTE:
      return ddk::Component::Byte;
    case RC_SHORT:
      return ddk::Component::Short;
    case RC_FLOAT:
      return ddk::Component::Float;
    case RC_FIXED:
      return ddk::Component::Fixed;
    default:
      return std::nullopt;
  }
}

// Bytes from one element to the next: a stride of 0 means packed.
inline RCsizei effectiveStride(const ClientArray &array) {
  const RCsizei bytes = array.type == RC_BYTE ? 1 : array.type == RC_SHORT ? 2 : 4;
  return array.stride ? array.stride : array.size * bytes;
}

struct ArrayTokens {
  RCenum array, pointer, size, type, stride, bufferBinding;  // size 0: the array has no size to ask for
  ClientArray ArrayState::*member;
};

inline constexpr ArrayTokens kArrays[] = {
    {RC_VERTEX_ARRAY, RC_VERTEX_ARRAY_POINTER, RC_VERTEX_ARRAY_SIZE, RC_VERTEX_ARRAY_TYPE, RC_VERTEX_ARRAY_STRIDE,
     RC_VERTEX_ARRAY_BUFFER_BINDING, &ArrayState::vertex},
    {RC_NORMAL_ARRAY, RC_NORMAL_ARRAY_POINTER, 0, RC_NORMAL_ARRAY_TYPE, RC_NORMAL_ARRAY_STRIDE,
     RC_NORMAL_ARRAY_BUFFER_BINDING, &ArrayState::normal},
    {RC_TEXTURE_COORD_ARRAY, RC_TEXTURE_COORD_ARRAY_POINTER, RC_TEXTURE_COORD_ARRAY_SIZE, RC_TEXTURE_COORD_ARRAY_TYPE,
     RC_TEXTURE_COORD_ARRAY_STRIDE, RC_TEXTURE_COORD_ARRAY_BUFFER_BINDING, &ArrayState::texCoord},
};

inline ClientArray *findArray(ArrayState &arrays, RCenum name) {
  for (const ArrayTokens &row : kArrays) {
    if (row.array == name) return &(arrays.*row.member);
  }
  return nullptr;
}

inline const ClientArray *findArrayByPointer(const ArrayState &arrays, RCenum pname) {
  for (const ArrayTokens &row : kArrays) {
    if (row.pointer == pname) return &(arrays.*row.member);
  }
  return nullptr;
}

// An enabled array without memory makes the whole draw call yield nothing. [reference 4.7]
inline bool hasNullPointer(const ArrayState &arrays) {
  for (const ArrayTokens &row : kArrays) {
    const ClientArray &array = arrays.*row.member;
    if (array.enabled && !array.pointer) return true;
  }
  return false;
}

// The array as geometry reads it; without data if it is off.
inline ddk::ArrayView viewOf(const ClientArray &array) {
  if (!array.enabled) return {};
  return {static_cast<const std::byte *>(array.pointer), *findComponent(array.type), size_t(effectiveStride(array))};
}

}  // namespace rc::api
