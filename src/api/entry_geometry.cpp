// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: vertex arrays and draw calls. [spec 3.6; G 7]
#include <optional>

#include "RC/rc.h"
#include "api/arrays.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

// `array` is the array's token; sizes other than its own are errors unless it may have several.
void setPointer(Context &context, RCenum array, RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  const ArrayTokens &tokens = *findArrayTokens(array);
  ArrayState &arrays = context.state.arrays;
  ClientArray &target = arrays.*tokens.member;
  if (!tokens.hasType(type)) return context.fail(RC_INVALID_ENUM, "type 0x%04X is no type of this array", type);
  if (stride < 0) return context.fail(RC_INVALID_VALUE, "stride is %d", stride);
  const std::shared_ptr<Buffer> &buffer = arrays.arrayBuffer.buffer;
  if (buffer && buffer->bytes.empty()) return context.fail(RC_INVALID_OPERATION, "the bound buffer has no data");
  if (buffer && reinterpret_cast<size_t>(pointer) >= buffer->bytes.size()) {
    return context.fail(RC_INVALID_VALUE, "the offset lies beyond the %zu bytes of the buffer", buffer->bytes.size());
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
  if (size < 1 || size > RCint(PaletteState::kMatrices)) return context.fail(RC_INVALID_VALUE, "size is %d", size);
  setPointer(context, array, size, type, stride, pointer);
}

void setClientState(Context &context, RCenum name, bool enabled) {
  if (name == RC_POINT_SIZE_ARRAY_OES) return;  // accepted: there are no points
  ClientArray *array = findArray(context.state.arrays, name);
  if (!array) return context.fail(RC_INVALID_ENUM, "0x%04X is no array", name);
  array->enabled = enabled;
}

std::optional<ddk::Primitive> primitiveOf(RCenum mode) {
  switch (mode) {
    case RC_TRIANGLES:
      return ddk::Primitive::Triangles;
    case RC_QUADS:
      return ddk::Primitive::Quads;
    case RC_TRIANGLE_FAN:
      return ddk::Primitive::TriangleFan;
    case RC_TRIANGLE_STRIP:
      return ddk::Primitive::TriangleStrip;
    default:
      return std::nullopt;
  }
}

std::optional<ddk::IndexType> indexTypeOf(RCenum type) {
  switch (type) {
    case RC_BYTE:
    case RC_UNSIGNED_BYTE:
      return ddk::IndexType::Byte;
    case RC_SHORT:
    case RC_UNSIGNED_SHORT:
      return ddk::IndexType::Short;
    case RC_INT:
    case RC_UNSIGNED_INT:
      return ddk::IndexType::Int;
    default:
      return std::nullopt;
  }
}

uint32_t flagsOf(const State &state) {
  uint32_t flags = 0;
  if (state.textureOnly) flags |= hal::kTextureOnly;
  if (state.shadow.transmittance) flags |= hal::kTransmittanceShadow;
  if (state.shadow.textureAlpha) flags |= hal::kAlphaShadow;
  return flags;
}

// A material object by name; without one, its values of this moment, stored once for equal draws. [spec 3.5]
uint32_t materialFor(const State &state, ddk::GeometrySet &set) {
  if (state.boundMaterial != 0) return state.boundMaterial;
  if (set.captured.empty() || set.captured.back() != state.material0) set.captured.push_back(state.material0);
  return hal::kNamedMaterials + static_cast<uint32_t>(set.captured.size() - 1);
}

ddk::ArrayView viewIfEnabled(const ClientArray &array) { return array.enabled ? viewOf(array) : ddk::ArrayView{}; }

// Vertices are skinned once the palette is on and both of its pointers are set, as the original does.
void addPalette(const State &state, ddk::DrawCall &call) {
  const ArrayState &arrays = state.arrays;
  if (!state.palette.enabled || !hasSource(arrays.matrixIndex) || !hasSource(arrays.weight)) return;
  call.matrixIndices = viewOf(arrays.matrixIndex);
  call.weights = viewOf(arrays.weight);
  call.palette = state.palette.matrices;
}

void draw(Context &context, ddk::Primitive primitive, const ddk::IndexView &indices) {
  const ArrayState &arrays = context.state.arrays;
  if (!arrays.vertex.enabled || hasNullPointer(arrays)) return;
  ddk::GeometrySet &set = context.scene.target();
  ddk::DrawCall call{.primitive = primitive, .indices = indices};
  call.vertices = viewIfEnabled(arrays.vertex);
  call.normals = viewIfEnabled(arrays.normal);
  call.texCoords = viewIfEnabled(arrays.texCoord);
  call.colors = viewIfEnabled(arrays.color);
  addPalette(context.state, call);
  call.worldFromObject = context.state.matrices.modelview.current();
  call.textureMatrix = context.state.matrices.texture.current();
  call.material = materialFor(context.state, set);
  call.flags = flagsOf(context.state);
  ddk::appendTriangles(call, set);
  context.touch();
}

size_t bytesOf(ddk::IndexType type) { return type == ddk::IndexType::Byte ? 1 : type == ddk::IndexType::Short ? 2 : 4; }

// Indices from client memory, or from the bound element buffer by offset; no more than the buffer has.
std::optional<ddk::IndexView> indexView(Context &context, ddk::IndexType type, size_t count, const RCvoid *indices) {
  const std::shared_ptr<Buffer> &buffer = context.state.arrays.elementBuffer.buffer;
  if (!buffer && indices) return ddk::IndexView{type, static_cast<const std::byte *>(indices), 0, count};
  if (!buffer || buffer->bytes.empty()) {
    context.fail(RC_INVALID_OPERATION, buffer ? "the element buffer is empty" : "indices is NULL");
    return std::nullopt;
  }
  const size_t offset = std::min(reinterpret_cast<size_t>(indices), buffer->bytes.size());
  const size_t available = (buffer->bytes.size() - offset) / bytesOf(type);
  return ddk::IndexView{type, buffer->bytes.data() + offset, 0, std::min(count, available)};
}

}  // namespace

extern "C" {

void rcEnableClientState(RCenum array) {
  enter("rcEnableClientState", [&](Context &context) { setClientState(context, array, true); });
}

void rcDisableClientState(RCenum array) {
  enter("rcDisableClientState", [&](Context &context) { setClientState(context, array, false); });
}

void rcVertexPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcVertexPointer",
        [&](Context &context) { setPlainPointer(context, RC_VERTEX_ARRAY, 3, size, type, stride, pointer); });
}

void rcTexCoordPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcTexCoordPointer",
        [&](Context &context) { setPlainPointer(context, RC_TEXTURE_COORD_ARRAY, 2, size, type, stride, pointer); });
}

void rcNormalPointer(RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcNormalPointer",
        [&](Context &context) { setPlainPointer(context, RC_NORMAL_ARRAY, 3, 3, type, stride, pointer); });
}

void rcColorPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcColorPointer",
        [&](Context &context) { setPlainPointer(context, RC_COLOR_ARRAY, 4, size, type, stride, pointer); });
}

void rcMatrixIndexPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcMatrixIndexPointerOES",
        [&](Context &context) { setPalettePointer(context, RC_MATRIX_INDEX_ARRAY_OES, size, type, stride, pointer); });
}

void rcWeightPointerOES(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcWeightPointerOES",
        [&](Context &context) { setPalettePointer(context, RC_WEIGHT_ARRAY_OES, size, type, stride, pointer); });
}

void rcGetPointerv(RCenum pname, RCvoid **params) {
  enter("rcGetPointerv", [&](Context &context) {
    const ClientArray *array = findArrayByPointer(context.state.arrays, pname);
    if (!array) return context.fail(RC_INVALID_ENUM, "0x%04X is no array pointer", pname);
    if (params) *params = const_cast<RCvoid *>(array->pointer);
  });
}

void rcDrawArrays(RCenum mode, RCint first, RCsizei count) {
  enter("rcDrawArrays", [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    if (!primitive) return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not drawn", mode);
    if (first < 0 || count < 0) return context.fail(RC_INVALID_VALUE, "first is %d, count is %d", first, count);
    draw(context, *primitive, {.first = size_t(first), .count = size_t(count)});
  });
}

void rcDrawElements(RCenum mode, RCsizei count, RCenum type, const RCvoid *indices) {
  enter("rcDrawElements", [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    const auto indexType = indexTypeOf(type);
    if (!primitive) return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not drawn", mode);
    if (count < 0) return context.fail(RC_INVALID_VALUE, "count is %d", count);
    if (!indexType) return context.fail(RC_INVALID_ENUM, "type 0x%04X is no type of an index", type);
    if (const auto view = indexView(context, *indexType, size_t(count), indices)) draw(context, *primitive, *view);
  });
}

}  // extern "C"
