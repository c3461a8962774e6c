// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "calls/world.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace rc::fuzz {
namespace {

constexpr size_t kVertexMemory = 1 << 18;
constexpr size_t kLargestElement = 128 * 4;  // of the matrix palette

// Numbers that make triangles, then wild ones. Never freed: contexts may keep pointers.
std::byte *vertexMemory() {
  static std::byte *const memory = [] {
    auto *bytes = new std::byte[kVertexMemory];
    Spread random(7);
    for (size_t at = 0; at < kVertexMemory; at += sizeof(float)) {
      const bool wild = at >= kVertexMemory / 2 && random.next() % 8 == 0;
      const float value = wild ? kWildFloats[random.next() % kWildFloats.size()] : 2 * random.unit();
      std::memcpy(bytes + at, &value, sizeof value);
    }
    return bytes;
  }();
  return memory;
}

struct ArrayNames {
  RCenum array, pointer, stride, buffer;
};
constexpr ArrayNames kArrays[] = {
    {RC_VERTEX_ARRAY, RC_VERTEX_ARRAY_POINTER, RC_VERTEX_ARRAY_STRIDE, RC_VERTEX_ARRAY_BUFFER_BINDING},
    {RC_NORMAL_ARRAY, RC_NORMAL_ARRAY_POINTER, RC_NORMAL_ARRAY_STRIDE, RC_NORMAL_ARRAY_BUFFER_BINDING},
    {RC_COLOR_ARRAY, RC_COLOR_ARRAY_POINTER, RC_COLOR_ARRAY_STRIDE, RC_COLOR_ARRAY_BUFFER_BINDING},
    {RC_TEXTURE_COORD_ARRAY, RC_TEXTURE_COORD_ARRAY_POINTER, RC_TEXTURE_COORD_ARRAY_STRIDE,
     RC_TEXTURE_COORD_ARRAY_BUFFER_BINDING},
    {RC_MATRIX_INDEX_ARRAY_OES, RC_MATRIX_INDEX_ARRAY_POINTER_OES, RC_MATRIX_INDEX_ARRAY_STRIDE_OES,
     RC_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES},
    {RC_WEIGHT_ARRAY_OES, RC_WEIGHT_ARRAY_POINTER_OES, RC_WEIGHT_ARRAY_STRIDE_OES, RC_WEIGHT_ARRAY_BUFFER_BINDING_OES},
};

RCint integerOf(RCenum name) {
  RCint value = 0;
  rcGetIntegerv(name, &value);
  return value;
}

// Vertices of one array that lie in its memory; no limit where the library itself keeps to a buffer's end.
uint64_t drawableOf(const ArrayNames &names) {
  void *pointer = nullptr;
  rcGetPointerv(names.pointer, &pointer);
  if (!rcIsEnabled(names.array) || integerOf(names.buffer) != 0 || !pointer) return UINT64_MAX;
  const auto place = size_t(static_cast<std::byte *>(pointer) - vertexMemory());
  if (place >= kVertexMemory - kLargestElement) return 0;
  const auto stride = uint64_t(std::max(integerOf(names.stride), 1));
  return (kVertexMemory - kLargestElement - place) / stride + 1;
}

}  // namespace

World::World() {
  mDisplays[0] = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  mDisplays[1] = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  for (const EGLDisplay display : mDisplays) {
    eglInitialize(display, nullptr, nullptr);
    note(display);
  }
  EGLint count = 0;
  eglGetConfigs(mDisplays[0], nullptr, 0, &count);
  mConfigs.resize(size_t(count));
  eglGetConfigs(mDisplays[0], mConfigs.data(), count, &count);
  for (const EGLConfig config : mConfigs) note(config);
}

World::~World() {
  eglReleaseThread();
  for (const EGLDisplay display : mDisplays) eglTerminate(display);
}

void *World::handle(Input &in) {
  const uint8_t choice = in.byte();
  if (choice == 0) return nullptr;
  if (choice == 1) return reinterpret_cast<void *>(uintptr_t(in.raw<uint32_t>()));
  const std::lock_guard lock(mMutex);
  if (choice < 32) return display(choice);
  if (choice < 64) return config(choice);
  const size_t made = mHandles.size() - kDisplays - mConfigs.size();
  return made == 0 ? nullptr : mHandles[mHandles.size() - 1 - choice % made];
}

void World::note(void *handle) {
  const std::lock_guard lock(mMutex);
  const bool isNew = std::find(mHandles.begin(), mHandles.end(), handle) == mHandles.end();
  if (handle && isNew) mHandles.push_back(handle);
}

void World::noteSync(EGLSync sync) {
  note(sync);
  const std::lock_guard lock(mMutex);
  if (sync) mSyncs.push_back({sync, eglGetCurrentContext()});
}

bool World::isOwn(EGLSync sync) {
  const std::lock_guard lock(mMutex);
  const EGLContext context = eglGetCurrentContext();
  for (const KnownSync &known : mSyncs) {
    if (known.sync == sync && known.context != context) return false;
  }
  return true;
}

const std::byte *World::vertices(size_t offset) { return vertexMemory() + offset % kVertexMemory; }

uint64_t World::drawable() {
  uint64_t least = UINT64_MAX;
  for (const ArrayNames &names : kArrays) least = std::min(least, drawableOf(names));
  return least;
}

}  // namespace rc::fuzz
