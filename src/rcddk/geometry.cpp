// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/geometry.h"

#include <algorithm>

#include "rcddk/assembler.h"

namespace rc::ddk {
namespace {

size_t primitiveCount(Primitive primitive, size_t vertices) {
  switch (primitive) {
    case Primitive::Triangles:
      return vertices / 3;
    case Primitive::Quads:
      return vertices / 4;
    case Primitive::TriangleFan:
    case Primitive::TriangleStrip:
      return vertices < 3 ? 0 : vertices - 2;
  }
  return 0;
}

size_t trianglesOf(Primitive primitive) { return primitive == Primitive::Quads ? 2 : 1; }

// Calls emit with the three vertices of each triangle of a primitive, and the last one of the primitive, all numbered
// within the draw call.
template <class Emit>
void forEachTriangle(Primitive primitive, size_t i, Emit &&emit) {
  switch (primitive) {
    case Primitive::Triangles:
      return emit(3 * i, 3 * i + 1, 3 * i + 2, 3 * i + 2);
    case Primitive::Quads:
      emit(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3);
      return emit(4 * i, 4 * i + 2, 4 * i + 3, 4 * i + 3);
    case Primitive::TriangleFan:
      return emit(size_t{0}, i + 1, i + 2, i + 2);
    case Primitive::TriangleStrip:  // every second triangle is turned round, so that all face the same way
      return i % 2 == 0 ? emit(i, i + 1, i + 2, i + 2) : emit(i + 1, i, i + 2, i + 2);
  }
}

void resize(GeometrySet &set, size_t triangles) {
  set.triangles.resize(triangles);
  set.attributes.resize(triangles);
}

// Primitives of a draw call that are assembled at a time, and where their triangles begin in the set.
struct Chunk {
  static constexpr size_t kPrimitives = 1024;

  size_t begin, end, first;
  Assembled assembled{};
};

void assemble(const DrawCall &call, GeometrySet &set, Chunk &chunk) {
  Assembler assembler(call, {set.triangles.data() + chunk.first, set.attributes.data() + chunk.first});
  for (size_t i = chunk.begin; i < chunk.end; ++i) {
    forEachTriangle(call.primitive, i,
                    [&](size_t i0, size_t i1, size_t i2, size_t last) { assembler.add(i0, i1, i2, last); });
  }
  chunk.assembled = assembler.result();
}

// Closes the gaps that skipped triangles have left behind the first `count` triangles of the set.
void closeGaps(GeometrySet &set, std::span<const Chunk> chunks, size_t count) {
  for (const Chunk &chunk : chunks) {
    if (chunk.first != count) {
      const auto move = [&](auto &rows) {
        const auto from = rows.begin() + std::ptrdiff_t(chunk.first);
        std::move(from, from + std::ptrdiff_t(chunk.assembled.count), rows.begin() + std::ptrdiff_t(count));
      };
      move(set.triangles);
      move(set.attributes);
    }
    count += chunk.assembled.count;
    set.skipped = set.skipped + chunk.assembled.skipped;
  }
  resize(set, count);
}

// Of a set: nodes have 30 bits for the names of their children.
constexpr size_t kMostTriangles = size_t{1} << 29;

// Triangles that may come of a primitive: each plane that cuts adds one.
size_t mostOf(const DrawCall &call) { return trianglesOf(call.primitive) * (1 + call.clipPlanes.size()); }

// The primitives begin ... end - 1 of a draw call.
void appendPart(const DrawCall &call, size_t begin, size_t end, GeometrySet &set, const Workers &workers) {
  const size_t most = mostOf(call);
  const size_t before = set.triangles.size();
  std::vector<Chunk> chunks;
  for (size_t i = begin; i < end; i += Chunk::kPrimitives) {
    chunks.push_back({i, std::min(i + Chunk::kPrimitives, end), before + (i - begin) * most});
  }
  if (before + (end - begin) * most > kMostTriangles) throw std::bad_alloc();
  resize(set, before + (end - begin) * most);
  if (chunks.size() == 1) {
    assemble(call, set, chunks[0]);
  } else {
    workers.forEach(chunks.size(), [&](size_t i, int) { assemble(call, set, chunks[i]); });
  }
  closeGaps(set, chunks, before);
}

}  // namespace

void appendTriangles(const DrawCall &call, GeometrySet &set, const Workers &workers) {
  // A part at a time: indices may name vertices that are not there, and need no room.
  const size_t part = 256 * Chunk::kPrimitives / mostOf(call);
  const size_t before = set.triangles.size(), primitives = primitiveCount(call.primitive, call.indices.count);
  const SkippedTriangles skipped = set.skipped;
  try {
    for (size_t begin = 0; begin < primitives; begin += part) {
      appendPart(call, begin, std::min(begin + part, primitives), set, workers);
    }
  } catch (...) {  // out of memory: as if nothing had been drawn
    resize(set, before);
    set.skipped = skipped;
    throw;
  }
  set.filtersShadow |= (call.flags & hal::kFiltersShadow) != 0;
  set.interpolates |= call.normals.data || call.colors.data || call.flags & hal::kTangentFrame;
}

}  // namespace rc::ddk
