// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Calls whose pointers come with sizes: memory is as large as the specification says, to the byte.
#include "calls/functions.h"
#include "image_memory.h"

namespace rc::fuzz {
namespace {

// Bytes out of the input, or numbers that follow from it.
std::unique_ptr<std::byte[]> bytesFor(Input &in, size_t size) {
  std::unique_ptr<std::byte[]> bytes(new std::byte[size]);
  Spread random(in.byte());
  for (size_t i = 0; i < size; ++i) bytes[i] = std::byte(random.next());
  return bytes;
}

void bufferData(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token();
  const RCsizeiptr size = in.below(4) ? RCsizeiptr(in.byte()) * 16 : RCsizeiptr(in.raw<int64_t>());
  const RCenum usage = in.token();
  constexpr RCsizeiptr kMost = 1 << 16;
  if (size <= 0 || size > kMost || in.below(8) == 0) return rcBufferData(target, size, nullptr, usage);
  rcBufferData(target, size, bytesFor(in, size_t(size)).get(), usage);
}

void bufferSubData(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token();
  const RCintptr offset = in.below(4) ? RCintptr(in.byte()) : RCintptr(in.raw<int64_t>());
  const RCsizeiptr size = in.below(4) ? RCsizeiptr(in.byte()) : RCsizeiptr(in.raw<int64_t>());
  constexpr RCsizeiptr kMost = 1 << 16;  // no buffer is so large that more could be changed
  rcBufferSubData(target, offset, size, bytesFor(in, size_t(std::clamp<RCsizeiptr>(size, 0, kMost))).get());
}

struct ImageArguments {
  RCenum format, type;
  RCsizei width, height;

  explicit ImageArguments(Input &in)
      : format(in.token()), type(in.token()), width(in.integer()), height(in.integer()) {}
};

RCint alignmentOf(RCenum name) {
  RCint alignment = 1;
  rcGetIntegerv(name, &alignment);
  return alignment;
}

void texImage(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token();
  const RCint level = in.integer();
  const RCint internal = RCint(in.token());
  const RCint border = in.integer();
  const ImageArguments a(in);
  Pixels pixels(imageBytes(a.width, a.height, texelBytes(a.format, a.type), alignmentOf(RC_UNPACK_ALIGNMENT)), in);
  rcTexImage2D(target, level, internal, a.width, a.height, border, a.format, a.type, pixels.data());
}

void texSubImage(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token();
  const RCint level = in.integer(), x = in.integer(), y = in.integer();
  const ImageArguments a(in);
  Pixels pixels(imageBytes(a.width, a.height, texelBytes(a.format, a.type), alignmentOf(RC_UNPACK_ALIGNMENT)), in);
  rcTexSubImage2D(target, level, x, y, a.width, a.height, a.format, a.type, pixels.data());
}

void compressedTexImage(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token(), format = in.token();
  const RCint level = in.integer(), border = in.integer();
  const RCsizei width = in.integer(), height = in.integer(), size = in.integer();
  Pixels pixels(uint64_t(std::max(size, 0)), in);
  rcCompressedTexImage2D(target, level, format, width, height, border, size, pixels.data());
}

void compressedTexSubImage(const Site &site) {
  Input &in = site.in;
  const RCenum target = in.token(), format = in.token();
  const RCint level = in.integer(), x = in.integer(), y = in.integer();
  const RCsizei width = in.integer(), height = in.integer(), size = in.integer();
  Pixels pixels(uint64_t(std::max(size, 0)), in);
  rcCompressedTexSubImage2D(target, level, x, y, width, height, format, size, pixels.data());
}

// Room for a part of the picture; null for parts of a size that nobody has memory for.
void readPixels(const Site &site) {
  Input &in = site.in;
  const RCint x = in.integer(), y = in.integer();
  const ImageArguments a(in);
  const uint64_t bytes =
      imageBytes(a.width, a.height, texelBytes(a.format, RC_UNSIGNED_BYTE), alignmentOf(RC_PACK_ALIGNMENT));
  Pixels pixels(bytes > Pixels::kMost ? 0 : bytes, in);
  rcReadPixels(x, y, a.width, a.height, a.format, a.type, bytes > Pixels::kMost ? nullptr : pixels.data());
}

void readRays(const Site &site) {
  Input &in = site.in;
  const RCint x = in.integer(), y = in.integer();
  const RCsizei width = in.integer(), height = in.integer();
  const RCenum name = in.token();
  const uint64_t values = width > 0 && height > 0 ? uint64_t(width) * uint64_t(height) : 0;
  constexpr uint64_t kMost = 1 << 16;
  const std::unique_ptr<RCfloat[]> memory(values > kMost ? nullptr : new RCfloat[size_t(values)]);
  rcReadRaysRCX(x, y, width, height, name, memory.get());
}

template <auto generate>
void generateNames(const Site &site) {
  const int n = site.in.byte() % 24 - 4;
  const std::unique_ptr<RCuint[]> names(new RCuint[size_t(std::max(n, 0))]);
  generate(n, site.in.below(8) ? names.get() : nullptr);
}

template <auto remove>
void deleteNames(const Site &site) {
  const int n = site.in.byte() % 24 - 4;
  const std::unique_ptr<RCuint[]> names(new RCuint[size_t(std::max(n, 0))]);
  for (int i = 0; i < n; ++i) names[size_t(i)] = site.in.below(8) ? site.in.byte() : site.in.token();
  remove(n, site.in.below(8) ? names.get() : nullptr);
}

// An offset where a buffer is bound, else null or a place in the vertices' memory.
const RCvoid *arrayPointer(Input &in) {
  const auto place = in.below(4) ? size_t(in.raw<uint16_t>()) * 4 : size_t(in.raw<uint32_t>());
  RCint buffer = 0;
  rcGetIntegerv(RC_ARRAY_BUFFER_BINDING, &buffer);
  if (buffer != 0) return reinterpret_cast<const RCvoid *>(place);
  return place == 0 ? nullptr : World::vertices(place);
}

template <auto setPointer>
void setSizedArray(const Site &site) {
  const RCint size = site.in.integer();
  const RCenum type = site.in.token();
  const RCsizei stride = site.in.integer();
  setPointer(size, type, stride, arrayPointer(site.in));
}

template <auto setPointer>
void setArray(const Site &site) {
  const RCenum type = site.in.token();
  const RCsizei stride = site.in.integer();
  setPointer(type, stride, arrayPointer(site.in));
}

constexpr uint64_t kMostVertices = 600;  // so that an input takes milliseconds

void drawArrays(const Site &site) {
  const RCenum mode = site.in.token();
  RCint first = site.in.integer(), count = site.in.integer();
  const uint64_t most = World::drawable();
  if (count > 0) count = RCint(std::min({uint64_t(count), most, kMostVertices}));
  if (first > 0 && most != UINT64_MAX) first = RCint(std::min(uint64_t(first), most - uint64_t(std::max(count, 0))));
  rcDrawArrays(mode, first, count);
}

uint64_t valuesOf(RCenum indexType) {
  if (indexType == RC_UNSIGNED_BYTE || indexType == RC_BYTE) return 1 << 8;
  return indexType == RC_UNSIGNED_SHORT || indexType == RC_SHORT ? 1 << 16 : uint64_t{1} << 32;
}

void drawElements(const Site &site) {
  Input &in = site.in;
  const RCenum mode = in.token(), type = in.token();
  const RCsizei count = std::min(in.integer(), int32_t(kMostVertices));
  const uint64_t most = World::drawable();
  RCint buffer = 0;
  rcGetIntegerv(RC_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
  if (buffer != 0) {
    const auto offset = in.below(4) ? size_t(in.byte()) : size_t(in.raw<uint32_t>());
    // The buffer may hold any index: there has to be memory for all of them.
    if (most >= valuesOf(type)) rcDrawElements(mode, count, type, reinterpret_cast<const RCvoid *>(offset));
    return;
  }
  const size_t size = size_t(std::max(count, 0)), bytes = valuesOf(type) == 1 << 8    ? 1
                                                          : valuesOf(type) == 1 << 16 ? 2
                                                                                      : 4;
  const std::unique_ptr<std::byte[]> indices(new std::byte[size * bytes]);
  Spread random(in.byte());
  for (size_t i = 0; i < size; ++i) {
    const auto index = uint32_t(random.next() % std::max<uint64_t>(std::min<uint64_t>(most, 1 << 20), 1));
    std::memcpy(indices.get() + i * bytes, &index, bytes);
  }
  if (most > 0) rcDrawElements(mode, count, type, in.below(8) ? indices.get() : nullptr);
}

// A mirror opposite a mirror of glass doubles its rays at each bounce: few are enough.
void depthBounce(const Site &site) { rcDepthBounce(site.in.byte() % 4); }

constexpr Function kCalls[] = {
    {"rcBufferData", bufferData},
    {"rcBufferSubData", bufferSubData},
    {"rcTexImage2D", texImage},
    {"rcTexSubImage2D", texSubImage},
    {"rcCompressedTexImage2D", compressedTexImage},
    {"rcCompressedTexSubImage2D", compressedTexSubImage},
    {"rcReadPixels", readPixels},
    {"rcReadRaysRCX", readRays},
    {"rcGenBuffers", generateNames<rcGenBuffers>},
    {"rcGenMaterials", generateNames<rcGenMaterials>},
    {"rcGenTextures", generateNames<rcGenTextures>},
    {"rcDeleteBuffers", deleteNames<rcDeleteBuffers>},
    {"rcDeleteMaterials", deleteNames<rcDeleteMaterials>},
    {"rcDeleteTextures", deleteNames<rcDeleteTextures>},
    {"rcVertexPointer", setSizedArray<rcVertexPointer>},
    {"rcColorPointer", setSizedArray<rcColorPointer>},
    {"rcTexCoordPointer", setSizedArray<rcTexCoordPointer>},
    {"rcMatrixIndexPointerOES", setSizedArray<rcMatrixIndexPointerOES>},
    {"rcWeightPointerOES", setSizedArray<rcWeightPointerOES>},
    {"rcNormalPointer", setArray<rcNormalPointer>},
    {"rcPointSizePointerOES", setArray<rcPointSizePointerOES>},
    {"rcDrawArrays", drawArrays},
    {"rcDrawElements", drawElements},
    {"rcDepthBounce", depthBounce},
};

}  // namespace

std::span<const Function> sizedCalls() { return kCalls; }

}  // namespace rc::fuzz
