// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vertex_stage.cpp: for each instruction set, and the choice among them.
#include "rcddk/vertex_stage.h"

#include "base/simd_targets.h"
#include "rchal/scene_view.h"

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

HWY_INLINE Vectors3 load(const float (&columns)[3][TriangleColumns::kRoom], size_t i) {
  const Tag d;
  return {hn::Load(d, columns[0] + i), hn::Load(d, columns[1] + i), hn::Load(d, columns[2] + i)};
}

HWY_INLINE void store(const Vectors3 &v, float (&columns)[3][TriangleColumns::kRoom], size_t i) {
  const Tag d;
  hn::Store(v.x, d, columns[0] + i);
  hn::Store(v.y, d, columns[1] + i);
  hn::Store(v.z, d, columns[2] + i);
}

HWY_INLINE Vector times(float factor, Vector v) { return hn::Mul(hn::Set(Tag(), factor), v); }

HWY_INLINE Vectors3 plus(const Vectors3 &a, const Vectors3 &b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vectors3 minus(const Vectors3 &a, const Vectors3 &b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Vector dot(const Vectors3 &a, const Vectors3 &b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vectors3 cross(const Vectors3 &a, const Vectors3 &b) {
  const auto minor = [](Vector p, Vector q, Vector r, Vector s)
                         HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
  return {minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
}

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
  const Vector length = hn::Sqrt(dot(v, v));
  const auto directed = hn::And(hn::Gt(length, hn::Zero(d)), hn::Lt(length, hn::Set(d, kInfinity)));
  const auto part = [&](Vector c) { return hn::IfThenElseZero(directed, hn::Div(c, length)); };
  return {part(v.x), part(v.y), part(v.z)};
}

void positions(const Mat4 &matrix, size_t count, TriangleColumns &triangles) {
  for (auto &corner : triangles.position) {
    for (size_t i = 0; i < count; i += hn::Lanes(Tag())) store(transform(matrix, load(corner, i)), corner, i);
  }
}

void normals(const glm::mat3 &matrix, size_t count, TriangleColumns &triangles) {
  for (auto &corner : triangles.normal) {
    for (size_t i = 0; i < count; i += hn::Lanes(Tag())) store(unit(transform(matrix, load(corner, i))), corner, i);
  }
}

// The few whose areas a float cannot square: hal::planeOf() itself.
HWY_NOINLINE void setPlane(size_t i, TriangleColumns &triangles) {
  Vec3 corners[3];
  for (size_t k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) corners[k][axis] = triangles.position[k][axis][i];
  }
  const hal::TrianglePlane plane = hal::planeOf(corners[0], corners[1], corners[2]);
  const Vec3 normal = std::isfinite(plane.doubleArea) ? plane.flatNormal : Vec3(0);
  for (int axis = 0; axis < 3; ++axis) triangles.flatNormal[axis][i] = normal[axis];
  triangles.doubleArea[i] = isFinite(corners[0] + corners[1] + corners[2]) ? plane.doubleArea : NAN;
  triangles.safeOffset[i] = plane.safeOffset;
}

HWY_INLINE auto isFinite(const Vectors3 &v) {
  return hn::And(hn::IsFinite(v.x), hn::And(hn::IsFinite(v.y), hn::IsFinite(v.z)));
}

HWY_INLINE Vector largest(const Vectors3 &v) { return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z))); }

void planes(size_t count, TriangleColumns &triangles) {
  const Tag d;
  const auto set = [d](float value) HWY_ATTR { return hn::Set(d, value); };
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Vectors3 v0 = load(triangles.position[0], i), v1 = load(triangles.position[1], i),
                   v2 = load(triangles.position[2], i);
    const Vectors3 a = minus(v1, v0), b = minus(v2, v0), c = minus(v2, v1), edges = cross(a, b);
    const Vector area = hn::Sqrt(dot(edges, edges));
    const Vector longest = hn::Max(dot(a, a), hn::Max(dot(b, b), dot(c, c))), slenderness = hn::Div(longest, area);
    const auto sliver = hn::And(hn::Gt(slenderness, set(hal::kSliver)), hn::Lt(longest, set(kInfinity)));
    const Vector share = hn::Min(times(hal::kSliverError, slenderness), set(hal::kMostOfEdge));
    const Vector sliverOffset = hn::IfThenElseZero(sliver, hn::Mul(hn::Sqrt(longest), share));
    const Vector error = times(hal::kPositionError, hn::Max(largest(v0), hn::Max(largest(v1), largest(v2))));
    const auto finite = isFinite(plus(plus(v0, v1), v2));
    store({hn::Div(edges.x, area), hn::Div(edges.y, area), hn::Div(edges.z, area)}, triangles.flatNormal, i);
    hn::Store(hn::IfThenElse(finite, area, set(NAN)), d, triangles.doubleArea + i);
    hn::Store(hn::Max(error, sliverOffset), d, triangles.safeOffset + i);
    const auto plain = hn::And(hn::Gt(area, set(kLeastPlainLength)), hn::Lt(area, set(kMostPlainLength)));
    if (HWY_LIKELY(hn::AllTrue(d, plain))) continue;
    for (size_t k = i; k < std::min(i + hn::Lanes(d), count); ++k) setPlane(k, triangles);
  }
}

void completeWith(bool clockwiseFront, size_t count, TriangleColumns &triangles) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const Vector zero = hn::Zero(d), side = hn::Set(d, clockwiseFront ? -1.0f : 1.0f);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Vectors3 flat = load(triangles.flatNormal, i);
    const Vectors3 front{hn::Mul(flat.x, side), hn::Mul(flat.y, side), hn::Mul(flat.z, side)};
    auto some = hn::Lt(zero, zero);  // none
    for (auto &corner : triangles.normal) {
      const Vectors3 own = load(corner, i);
      const auto has = hn::Or(hn::Ne(own.x, zero), hn::Or(hn::Ne(own.y, zero), hn::Ne(own.z, zero)));
      some = hn::Or(some, has);
      store({hn::IfThenElse(has, own.x, front.x), hn::IfThenElse(has, own.y, front.y),
             hn::IfThenElse(has, own.z, front.z)},
            corner, i);
    }
    const auto flag = hn::IfThenElseZero(hn::RebindMask(du, some), hn::Set(du, uint32_t{hal::kHasNormals}));
    hn::Store(flag, du, triangles.hasNormals + i);
  }
}

}  // namespace rc::ddk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rc::ddk {

HWY_EXPORT(positions);
HWY_EXPORT(normals);
HWY_EXPORT(planes);
HWY_EXPORT(completeWith);

void transformPositions(const Mat4 &matrix, size_t count, TriangleColumns &triangles) {
  HWY_DYNAMIC_DISPATCH(positions)(matrix, count, triangles);
}

void transformNormals(const glm::mat3 &matrix, size_t count, TriangleColumns &triangles) {
  HWY_DYNAMIC_DISPATCH(normals)(matrix, count, triangles);
}

void setPlanes(size_t count, TriangleColumns &triangles) { HWY_DYNAMIC_DISPATCH(planes)(count, triangles); }

void completeNormals(bool clockwiseFront, size_t count, TriangleColumns &triangles) {
  HWY_DYNAMIC_DISPATCH(completeWith)(clockwiseFront, count, triangles);
}

}  // namespace rc::ddk
#endif
