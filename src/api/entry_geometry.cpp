// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: vertex arrays and draw calls. [spec 3.6; G 7]
#include "RC/rc.h"
#include "api/arrays.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

void setPointer(Context &context, ClientArray &array, RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  if (size != array.size) return context.fail(RC_INVALID_VALUE, "size is %d, not %d", size, array.size);
  if (!findComponent(type)) return context.fail(RC_INVALID_ENUM, "type 0x%04X is no type of an array", type);
  if (stride < 0) return context.fail(RC_INVALID_VALUE, "stride is %d", stride);
  array.type = type;
  array.stride = stride;
  array.pointer = pointer;
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
uint32_t materialFor(const MaterialTable &materials, ddk::GeometrySet &set) {
  if (materials.boundName() != 0) return materials.boundName();
  if (set.captured.empty() || set.captured.back() != materials.bound()) set.captured.push_back(materials.bound());
  return hal::kNamedMaterials + static_cast<uint32_t>(set.captured.size() - 1);
}

void draw(Context &context, ddk::Primitive primitive, const ddk::IndexView &indices) {
  const ArrayState &arrays = context.state.arrays;
  if (!arrays.vertex.enabled || hasNullPointer(arrays)) return;
  ddk::GeometrySet &set = context.scene.target();
  ddk::DrawCall call{.primitive = primitive, .indices = indices};
  call.vertices = viewOf(arrays.vertex);
  call.normals = viewOf(arrays.normal);
  call.texCoords = viewOf(arrays.texCoord);
  call.worldFromObject = context.state.matrices.modelview.current();
  call.textureMatrix = context.state.matrices.texture.current();
  call.material = materialFor(context.objects().materials, set);
  call.flags = flagsOf(context.state);
  ddk::appendTriangles(call, set);
  context.touch();
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
        [&](Context &context) { setPointer(context, context.state.arrays.vertex, size, type, stride, pointer); });
}

void rcTexCoordPointer(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcTexCoordPointer",
        [&](Context &context) { setPointer(context, context.state.arrays.texCoord, size, type, stride, pointer); });
}

void rcNormalPointer(RCenum type, RCsizei stride, const RCvoid *pointer) {
  enter("rcNormalPointer",
        [&](Context &context) { setPointer(context, context.state.arrays.normal, 3, type, stride, pointer); });
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
    if (!indices) return context.fail(RC_INVALID_OPERATION, "indices is NULL");
    draw(context, *primitive,
         {.type = *indexType, .data = static_cast<const std::byte *>(indices), .count = size_t(count)});
  });
}

}  // extern "C"
