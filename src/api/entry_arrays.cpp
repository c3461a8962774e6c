// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: vertex arrays, and what vertices without them have. [spec 3.6; G 7]
#include "RC/rc.h"
#include "api/arrays.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

// `array` is the array's token; sizes other than its own are errors unless it may have several.
void setPointer(Context &context, RCenum array, RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  const ArrayTokens &tokens = *findArrayTokens(array);
  ArrayState &arrays = context.state.arrays;
  ClientArray &target = arrays.*tokens.member;
  if (!tokens.hasType(type))
    return context.fail(RC_INVALID_ENUM, "type 0x%04X is no type of array 0x%04X", type, array);
  if (stride < 0) return context.fail(RC_INVALID_VALUE, "stride is %d, not 0 or more", stride);
  const std::shared_ptr<Buffer> &buffer = arrays.arrayBuffer.buffer;
  if (buffer && buffer->bytes.empty()) return context.fail(RC_INVALID_OPERATION, "the bound buffer has no data");
  if (buffer && reinterpret_cast<size_t>(pointer) >= buffer->bytes.size()) {
    return context.fail(RC_INVALID_VALUE, "pointer, an offset here, lies beyond the %zu bytes of the buffer",
                        buffer->bytes.size());
  }
  target.size = size;
  target.type = type;
  target.stride = stride;
  target.pointer = pointer;
  target.bufferName = arrays.arrayBuffer.name;
  target.buffer = buffer;
}

// Arrays of one size.
void setPlainPointer(Context &context, RCenum array, RCint wanted, RCint size, RCenum type, RCsizei stride,
                     const RCvoid *pointer) {
  if (size != wanted) return context.fail(RC_INVALID_VALUE, "size is %d, not %d", size, wanted);
  setPointer(context, array, size, type, stride, pointer);
}

// Arrays of the palette have up to as many values a vertex as it has matrices.
void setPalettePointer(Context &context, RCenum array, RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  if (!context.state.palette.enabled) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
  if (size < 1 || size > RCint(PaletteState::kMatrices))
    return context.fail(RC_INVALID_VALUE, "size is %d, not in 1 ... 128", size);
  setPointer(context, array, size, type, stride, pointer);
}

void setTexCoord(Context &context, RCenum unit, const Vec4 &coordinate) {
  if (unit != RC_TEXTURE0)
    return context.fail(RC_INVALID_ENUM, "target 0x%04X is not RC_TEXTURE0, the only unit", unit);
  context.state.arrays.currentTexCoord = coordinate;
}

void setClientState(Context &context, RCenum name, bool enabled) {
  ClientArray *array = findArray(context.state.arrays, name);
  if (!array)
    return context.fail(
        RC_INVALID_ENUM,
        "array 0x%04X is none of vertices, normals, colours, texture coordinates, palette or point sizes", name);
  array->enabled = enabled;
}

}  // namespace

extern "C" {

void rcEnableClientState(RCenum array) {
  enter(Call("rcEnableClientState", array), [&](Context &context) { setClientState(context, array, true); });
}

void rcDisableClientState(RCenum array) {
  enter(Call("rcDisableClientState", array), [&](Context &context) { setClientState(context, array, false); });
}

void rcVertexPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcVertexPointer", size, type, stride, pointer),
        [&](Context &context) { setPlainPointer(context, RC_VERTEX_ARRAY, 3, size, type, stride, pointer); });
}

void rcTexCoordPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcTexCoordPointer", size, type, stride, pointer),
        [&](Context &context) { setPlainPointer(context, RC_TEXTURE_COORD_ARRAY, 2, size, type, stride, pointer); });
}

void rcNormalPointer(RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcNormalPointer", type, stride, pointer),
        [&](Context &context) { setPlainPointer(context, RC_NORMAL_ARRAY, 3, 3, type, stride, pointer); });
}

void rcColorPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcColorPointer", size, type, stride, pointer),
        [&](Context &context) { setPlainPointer(context, RC_COLOR_ARRAY, 4, size, type, stride, pointer); });
}

void rcMatrixIndexPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcMatrixIndexPointerOES", size, type, stride, pointer),
        [&](Context &context) { setPalettePointer(context, RC_MATRIX_INDEX_ARRAY_OES, size, type, stride, pointer); });
}

void rcWeightPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcWeightPointerOES", size, type, stride, pointer),
        [&](Context &context) { setPalettePointer(context, RC_WEIGHT_ARRAY_OES, size, type, stride, pointer); });
}

void rcPointSizePointerOES(RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter(Call("rcPointSizePointerOES", type, stride, pointer),
        [&](Context &context) { setPointer(context, RC_POINT_SIZE_ARRAY_OES, 1, type, stride, pointer); });
}

void rcNormal3f(RCfloat nx, RCfloat ny, RCfloat nz) {
  enter(Call("rcNormal3f", nx, ny, nz), [&](Context &context) { context.state.arrays.currentNormal = {nx, ny, nz}; });
}

void rcNormal3x(RCfixed nx, RCfixed ny, RCfixed nz) {
  enter(Call("rcNormal3x", nx, ny, nz), [&](Context &context) {
    context.state.arrays.currentNormal = {fromFixed(nx), fromFixed(ny), fromFixed(nz)};
  });
}

void rcMultiTexCoord4f(RCenum target, RCfloat s, RCfloat t, RCfloat r, RCfloat q) {
  enter(Call("rcMultiTexCoord4f", target, s, t, r, q), [&](Context &context) {
    setTexCoord(context, target, {s, t, r, q});
  });
}

void rcMultiTexCoord4x(RCenum target, RCfixed s, RCfixed t, RCfixed r, RCfixed q) {
  enter(Call("rcMultiTexCoord4x", target, s, t, r, q), [&](Context &context) {
    setTexCoord(context, target, {fromFixed(s), fromFixed(t), fromFixed(r), fromFixed(q)});
  });
}

void rcGetPointerv(RCenum pname, RCvoid **params) {
  enter(Call("rcGetPointerv", pname, params), [&](Context &context) {
    const ClientArray *array = findArrayByPointer(context.state.arrays, pname);
    if (!array) return context.fail(RC_INVALID_ENUM, "pname 0x%04X is no pointer of an array", pname);
    if (params) *params = const_cast<RCvoid *>(array->pointer);
  });
}

}  // extern "C"
