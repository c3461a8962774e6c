// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: vertex arrays and draw calls. [spec 3.6; G 7]
#include <optional>

#include "RC/rc.h"
#include "api/arrays.h"
#include "api/convert.h"
#include "api/guard.h"
#include "rchal/units/coverage.h"

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

void setTexCoord(Context &context, RCenum unit, const Vec4 &coordinate) {
  if (unit != RC_TEXTURE0) return context.fail(RC_INVALID_ENUM, "0x%04X is not RC_TEXTURE0, the only unit", unit);
  context.state.arrays.currentTexCoord = coordinate;
}

void setClientState(Context &context, RCenum name, bool enabled) {
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

// Tokens of comparisons name their outcomes in their low bits: RC_LEQUAL is RC_NEVER + less + equal.
uint32_t surfaceFlags(const SurfaceState &surface) {
  uint32_t flags = 0;
  if (surface.frontFace == RC_CW) flags |= hal::kClockwiseFront;
  if (surface.cullFace && surface.cullMode != RC_BACK) flags |= hal::kCullFront;
  if (surface.cullFace && surface.cullMode != RC_FRONT) flags |= hal::kCullBack;
  if (surface.alphaTest) flags |= hal::alphaTestFlags(surface.alphaFunc - RC_NEVER, surface.alphaRef);
  return flags;
}

uint32_t flagsOf(const State &state) {
  uint32_t flags = 0;
  if (state.textureOnly) flags |= hal::kTextureOnly;
  if (state.shadow.transmittance) flags |= hal::kTransmittanceShadow;
  if (state.shadow.textureAlpha) flags |= hal::kAlphaShadow;
  return flags | surfaceFlags(state.surface);
}

// Planes that are on, without gaps.
struct ClipPlanes {
  std::array<Vec4, ClipState::kPlanes> planes;
  size_t count = 0;

  explicit ClipPlanes(const ClipState &state) {
    for (size_t i = 0; i < ClipState::kPlanes; ++i) {
      if (state.enabled[i]) planes[count++] = state.planes[i];
    }
  }
};

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
  if (!arrays.vertex.enabled || hasNullPointer(arrays)) return context.noteEmptyDraw();
  ddk::GeometrySet &set = context.scene.target();
  ddk::DrawCall call{.primitive = primitive, .indices = indices};
  call.vertices = viewIfEnabled(arrays.vertex);
  call.normals = viewIfEnabled(arrays.normal);
  call.texCoords = viewIfEnabled(arrays.texCoord);
  call.colors = viewIfEnabled(arrays.color);
  addPalette(context.state, call);
  call.worldFromObject = context.state.matrices.modelview.current();
  call.textureMatrix = context.state.matrices.texture.current();
  call.texCoord = arrays.currentTexCoord;
  const ClipPlanes clip(context.state.clip);
  call.clipPlanes = std::span(clip.planes).first(clip.count);
  call.flatShading = context.state.surface.shadeModel == RC_FLAT;
  call.material = materialFor(context.state, set);
  call.flags = flagsOf(context.state);
  if (context.boundMaterial().textures[ddk::kNormalMap].enabled) call.flags |= hal::kTangentFrame;
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
    if (!array) return context.fail(RC_INVALID_ENUM, "0x%04X is no array pointer", pname);
    if (params) *params = const_cast<RCvoid *>(array->pointer);
  });
}

void rcDrawArrays(RCenum mode, RCint first, RCsizei count) {
  enter(Call("rcDrawArrays", mode, first, count), [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    if (!primitive) return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not drawn", mode);
    if (first < 0 || count < 0) return context.fail(RC_INVALID_VALUE, "first is %d, count is %d", first, count);
    draw(context, *primitive, {.first = size_t(first), .count = size_t(count)});
  });
}

void rcDrawElements(RCenum mode, RCsizei count, RCenum type, const RCvoid *indices) {
  enter(Call("rcDrawElements", mode, count, type, indices), [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    const auto indexType = indexTypeOf(type);
    if (!primitive) return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not drawn", mode);
    if (count < 0) return context.fail(RC_INVALID_VALUE, "count is %d", count);
    if (!indexType) return context.fail(RC_INVALID_ENUM, "type 0x%04X is no type of an index", type);
    if (const auto view = indexView(context, *indexType, size_t(count), indices)) draw(context, *primitive, *view);
  });
}

}  // extern "C"
