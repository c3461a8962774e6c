// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// arrays.h: the client arrays by their tokens. [spec 3.6]
#pragma once

#include <algorithm>
#include <array>

#include "api/state.h"
#include "rcddk/geometry.h"

namespace rc::api {

// How values of a type are read, and how many bytes they have.
struct ComponentRow {
  RCenum type;
  ddk::Component component;
  RCsizei bytes;
};
inline constexpr ComponentRow kComponents[] = {
    {RC_BYTE, ddk::Component::Byte, 1},
    {RC_UNSIGNED_BYTE, ddk::Component::UnsignedByte, 1},
    {RC_SHORT, ddk::Component::Short, 2},
    {RC_UNSIGNED_SHORT, ddk::Component::UnsignedShort, 2},
    {RC_FLOAT, ddk::Component::Float, 4},
    {RC_FIXED, ddk::Component::Fixed, 4},
    {RC_UNSIGNED_INT, ddk::Component::UnsignedInt, 4},
};

// The row of a type that some array can have.
inline const ComponentRow &componentOf(RCenum type) {
  return *std::find_if(std::begin(kComponents), std::end(kComponents) - 1,
                       [&](const ComponentRow &row) { return row.type == type; });
}

// Bytes of one element.
inline RCsizei elementBytes(const ClientArray &array) { return array.size * componentOf(array.type).bytes; }

// Bytes from one element to the next: a stride of 0 means packed.
inline RCsizei effectiveStride(const ClientArray &array) { return array.stride ? array.stride : elementBytes(array); }

struct ArrayTokens {
  RCenum array, pointer, size, type, stride, bufferBinding;  // size 0: the array has no size to ask for
  ClientArray ArrayState::*member;
  std::array<RCenum, 6> types;  // that the array may have; unused places are 0

  bool hasType(RCenum asked) const { return asked != 0 && std::find(types.begin(), types.end(), asked) != types.end(); }
};

inline constexpr std::array<RCenum, 6> kPlainTypes{RC_BYTE, RC_SHORT, RC_FLOAT, RC_FIXED};

inline constexpr ArrayTokens kArrays[] = {
    {RC_VERTEX_ARRAY, RC_VERTEX_ARRAY_POINTER, RC_VERTEX_ARRAY_SIZE, RC_VERTEX_ARRAY_TYPE, RC_VERTEX_ARRAY_STRIDE,
     RC_VERTEX_ARRAY_BUFFER_BINDING, &ArrayState::vertex, kPlainTypes},
    {RC_NORMAL_ARRAY, RC_NORMAL_ARRAY_POINTER, 0, RC_NORMAL_ARRAY_TYPE, RC_NORMAL_ARRAY_STRIDE,
     RC_NORMAL_ARRAY_BUFFER_BINDING, &ArrayState::normal, kPlainTypes},
    {RC_TEXTURE_COORD_ARRAY, RC_TEXTURE_COORD_ARRAY_POINTER, RC_TEXTURE_COORD_ARRAY_SIZE, RC_TEXTURE_COORD_ARRAY_TYPE,
     RC_TEXTURE_COORD_ARRAY_STRIDE, RC_TEXTURE_COORD_ARRAY_BUFFER_BINDING, &ArrayState::texCoord, kPlainTypes},
    {RC_COLOR_ARRAY,
     RC_COLOR_ARRAY_POINTER,
     RC_COLOR_ARRAY_SIZE,
     RC_COLOR_ARRAY_TYPE,
     RC_COLOR_ARRAY_STRIDE,
     RC_COLOR_ARRAY_BUFFER_BINDING,
     &ArrayState::color,
     {RC_BYTE, RC_UNSIGNED_BYTE, RC_SHORT, RC_UNSIGNED_SHORT, RC_FIXED, RC_FLOAT}},
    {RC_MATRIX_INDEX_ARRAY_OES,
     RC_MATRIX_INDEX_ARRAY_POINTER_OES,
     RC_MATRIX_INDEX_ARRAY_SIZE_OES,
     RC_MATRIX_INDEX_ARRAY_TYPE_OES,
     RC_MATRIX_INDEX_ARRAY_STRIDE_OES,
     RC_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES,
     &ArrayState::matrixIndex,
     {RC_UNSIGNED_BYTE, RC_UNSIGNED_INT}},
    {RC_WEIGHT_ARRAY_OES,
     RC_WEIGHT_ARRAY_POINTER_OES,
     RC_WEIGHT_ARRAY_SIZE_OES,
     RC_WEIGHT_ARRAY_TYPE_OES,
     RC_WEIGHT_ARRAY_STRIDE_OES,
     RC_WEIGHT_ARRAY_BUFFER_BINDING_OES,
     &ArrayState::weight,
     {RC_FIXED, RC_FLOAT}},
    {RC_POINT_SIZE_ARRAY_OES,
     RC_POINT_SIZE_ARRAY_POINTER_OES,
     0,
     RC_POINT_SIZE_ARRAY_TYPE_OES,
     RC_POINT_SIZE_ARRAY_STRIDE_OES,
     RC_POINT_SIZE_ARRAY_BUFFER_BINDING_OES,
     &ArrayState::pointSize,
     {RC_FIXED, RC_FLOAT}},
};

inline const ArrayTokens *findArrayTokens(RCenum name) {
  for (const ArrayTokens &row : kArrays) {
    if (row.array == name) return &row;
  }
  return nullptr;
}

inline ClientArray *findArray(ArrayState &arrays, RCenum name) {
  const ArrayTokens *row = findArrayTokens(name);
  return row ? &(arrays.*row->member) : nullptr;
}

inline const ClientArray *findArrayByPointer(const ArrayState &arrays, RCenum pname) {
  for (const ArrayTokens &row : kArrays) {
    if (row.pointer == pname) return &(arrays.*row.member);
  }
  return nullptr;
}

// Whether there is something to read: client memory, or a buffer object.
inline bool hasSource(const ClientArray &array) { return array.buffer || array.pointer; }

// An enabled array without memory makes the whole draw call yield nothing. [reference 4.7]
inline bool hasNullPointer(const ArrayState &arrays) {
  for (const ArrayTokens &row : kArrays) {
    const ClientArray &array = arrays.*row.member;
    const bool read = row.array != RC_POINT_SIZE_ARRAY_OES;  // there are no points
    if (read && array.enabled && !hasSource(array)) return true;
  }
  return false;
}

// The array as geometry reads it. With a buffer object the pointer is an offset, and what lies beyond the buffer's
// end is never read.
inline ddk::ArrayView viewOf(const ClientArray &array) {
  ddk::ArrayView view{.type = componentOf(array.type).component,
                      .components = size_t(array.size),
                      .stride = size_t(effectiveStride(array))};
  if (!array.buffer) {
    view.data = static_cast<const std::byte *>(array.pointer);
    return view;
  }
  const Array<std::byte> &bytes = array.buffer->bytes;
  const auto offset = reinterpret_cast<size_t>(array.pointer);
  const auto element = size_t(elementBytes(array));
  // An emptied buffer has no address; the array is on all the same.
  static constexpr std::byte kNothing{};
  view.data = bytes.empty() ? &kNothing : bytes.data() + std::min(offset, bytes.size());
  view.elements = offset > bytes.size() || bytes.size() - offset < element
                      ? 0
                      : (bytes.size() - offset - element) / view.stride + 1;
  return view;
}

}  // namespace rc::api
