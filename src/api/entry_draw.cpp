// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: draw calls: what of the state they capture. [spec 3.6; G 7]
// Next: rcddk/geometry.h
#include <optional>

#include "RC/rc.h"
#include "api/arrays.h"
#include "api/guard.h"
#include "base/stopwatch.h"
#include "rchal/units/coverage.h"

using namespace rc;
using namespace rc::api;

namespace {

constexpr char kUndrawnMode[] =
    "mode 0x%04X is not RC_TRIANGLES, RC_TRIANGLE_STRIP, RC_TRIANGLE_FAN or RC_QUADS: rays meet triangles only";

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
  if (indices.count < 3) return;                       // no primitive; the frame before stays
  if (context.scene.drawEndsFrame()) context.touch();  // though there may be no memory for what is drawn
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
  const Stopwatch watch;
  ddk::appendTriangles(call, set, context.driver().workers());
  context.noteTransformed(watch.milliseconds());
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

void rcDrawArrays(RCenum mode, RCint first, RCsizei count) {
  enter(Call("rcDrawArrays", mode, first, count), [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    if (!primitive) return context.fail(RC_INVALID_ENUM, kUndrawnMode, mode);
    if (first < 0 || count < 0)
      return context.fail(RC_INVALID_VALUE, "first is %d and count %d, not 0 or more", first, count);
    draw(context, *primitive, {.first = size_t(first), .count = size_t(count)});
  });
}

void rcDrawElements(RCenum mode, RCsizei count, RCenum type, const RCvoid *indices) {
  enter(Call("rcDrawElements", mode, count, type, indices), [&](Context &context) {
    const auto primitive = primitiveOf(mode);
    const auto indexType = indexTypeOf(type);
    if (!primitive) return context.fail(RC_INVALID_ENUM, kUndrawnMode, mode);
    if (count < 0) return context.fail(RC_INVALID_VALUE, "count is %d, not 0 or more", count);
    if (!indexType) return context.fail(RC_INVALID_ENUM, "type 0x%04X is not RC_(UNSIGNED_)BYTE, _SHORT or _INT", type);
    if (const auto view = indexView(context, *indexType, size_t(count), indices)) draw(context, *primitive, *view);
  });
}

}  // extern "C"
