// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vertex_stage.cpp: for each instruction set, and the choice among them.
#include "rcddk/vertex_stage.h"

#include "base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rcddk/vertex_stage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rc::ddk::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = HWY_CAPPED(float, 16);
using Vector = hn::Vec<Tag>;

struct Vectors3 {
  Vector x, y, z;
};

HWY_INLINE Vectors3 load(const float (&columns)[3][VertexColumns::kRoom], size_t i) {
  const Tag d;
  return {hn::Load(d, columns[0] + i), hn::Load(d, columns[1] + i), hn::Load(d, columns[2] + i)};
}

HWY_INLINE void store(const Vectors3 &v, float (&columns)[3][VertexColumns::kRoom], size_t i) {
  const Tag d;
  hn::Store(v.x, d, columns[0] + i);
  hn::Store(v.y, d, columns[1] + i);
  hn::Store(v.z, d, columns[2] + i);
}

HWY_INLINE Vector times(float factor, Vector v) { return hn::Mul(hn::Set(Tag(), factor), v); }

// A row of the matrix: (m0 x + m1 y) + (m2 z + m3).
HWY_INLINE Vector rowOf(const Mat4 &m, int row, const Vectors3 &v) {
  const Vector xy = hn::Add(times(m[0][row], v.x), times(m[1][row], v.y));
  return hn::Add(xy, hn::Add(times(m[2][row], v.z), hn::Set(Tag(), m[3][row])));
}

// (m0 x + m1 y) + m2 z.
HWY_INLINE Vector rowOf(const glm::mat3 &m, int row, const Vectors3 &v) {
  return hn::Add(hn::Add(times(m[0][row], v.x), times(m[1][row], v.y)), times(m[2][row], v.z));
}

template <class Matrix>
HWY_INLINE Vectors3 transform(const Matrix &m, const Vectors3 &v) {
  return {rowOf(m, 0, v), rowOf(m, 1, v), rowOf(m, 2, v)};
}

// normalizedOr(v, 0) of base/vec.h.
HWY_INLINE Vectors3 unit(const Vectors3 &v) {
  const Tag d;
  const Vector squares = hn::Add(hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y)), hn::Mul(v.z, v.z));
  const Vector length = hn::Sqrt(squares);
  const auto directed = hn::And(hn::Gt(length, hn::Zero(d)), hn::Lt(length, hn::Set(d, kInfinity)));
  const auto part = [&](Vector c) { return hn::IfThenElseZero(directed, hn::Div(c, length)); };
  return {part(v.x), part(v.y), part(v.z)};
}

void positions(const Mat4 &matrix, size_t count, VertexColumns &vertices) {
  for (size_t i = 0; i < count; i += hn::Lanes(Tag())) {
    store(transform(matrix, load(vertices.position, i)), vertices.position, i);
  }
}

void normals(const glm::mat3 &matrix, size_t count, VertexColumns &vertices) {
  for (size_t i = 0; i < count; i += hn::Lanes(Tag())) {
    store(unit(transform(matrix, load(vertices.normal, i))), vertices.normal, i);
  }
}

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rc::ddk {

HWY_EXPORT(positions);
HWY_EXPORT(normals);

void transformPositions(const Mat4 &matrix, size_t count, VertexColumns &vertices) {
  HWY_DYNAMIC_DISPATCH(positions)(matrix, count, vertices);
}

void transformNormals(const glm::mat3 &matrix, size_t count, VertexColumns &vertices) {
  HWY_DYNAMIC_DISPATCH(normals)(matrix, count, vertices);
}

}  // namespace rc::ddk
#endif
