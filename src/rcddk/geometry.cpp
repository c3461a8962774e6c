// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/geometry.h"

#include <cstring>

#include "rcddk/clip.h"

namespace rc::ddk {
namespace {

template <class T>
T load(const std::byte *at) {
  T value;
  std::memcpy(&value, at, sizeof value);  // client memory need not be aligned
  return value;
}

// The i-th component of an element, as a plain number.
float component(const ArrayView &array, size_t element, size_t i) {
  const std::byte *at = array.data + element * array.stride;
  switch (array.type) {
    case Component::Byte:
      return load<int8_t>(at + i);
    case Component::UnsignedByte:
      return load<uint8_t>(at + i);
    case Component::Short:
      return load<int16_t>(at + 2 * i);
    case Component::UnsignedShort:
      return load<uint16_t>(at + 2 * i);
    case Component::UnsignedInt:
      return static_cast<float>(load<uint32_t>(at + 4 * i));
    case Component::Fixed:
      return static_cast<float>(load<int32_t>(at + 4 * i)) / 65536;
    case Component::Float:
      break;
  }
  return load<float>(at + 4 * i);
}

Vec3 loadVec3(const ArrayView &array, size_t element) {
  return {component(array, element, 0), component(array, element, 1), component(array, element, 2)};
}

Vec2 loadVec2(const ArrayView &array, size_t element) {
  return {component(array, element, 0), component(array, element, 1)};
}

// Integers of colours mean 0 ... 1; signed ones by (2 c + 1) / (2^b - 1), as in GL.
Rgb loadColor(const ArrayView &array, size_t element) {
  const Vec3 plain = loadVec3(array, element);
  switch (array.type) {
    case Component::Byte:
      return (2.0f * plain + 1.0f) / 255.0f;
    case Component::UnsignedByte:
      return plain / 255.0f;
    case Component::Short:
      return (2.0f * plain + 1.0f) / 65535.0f;
    case Component::UnsignedShort:
      return plain / 65535.0f;
    default:
      return plain;
  }
}

size_t loadIndex(const IndexView &indices, size_t i) {
  switch (indices.type) {
    case IndexType::Byte:
      return load<uint8_t>(indices.data + i);
    case IndexType::Short:
      return load<uint16_t>(indices.data + 2 * i);
    case IndexType::Int:
      return load<uint32_t>(indices.data + 4 * i);
    case IndexType::Sequence:
      break;
  }
  return indices.first + i;
}

// Calls emit with the three vertices of each triangle and the last one of its primitive, all numbered within the
// draw call.
template <class Emit>
void forEachTriangle(Primitive primitive, size_t count, Emit &&emit) {
  switch (primitive) {
    case Primitive::Triangles:
      for (size_t i = 0; i + 3 <= count; i += 3) emit(i, i + 1, i + 2, i + 2);
      break;
    case Primitive::Quads:
      for (size_t i = 0; i + 4 <= count; i += 4) {
        emit(i, i + 1, i + 2, i + 3);
        emit(i, i + 2, i + 3, i + 3);
      }
      break;
    case Primitive::TriangleFan:
      for (size_t i = 2; i < count; ++i) emit(size_t{0}, i - 1, i, i);
      break;
    case Primitive::TriangleStrip:  // every second triangle is turned round, so that all face the same way
      for (size_t i = 2; i < count; ++i) i % 2 == 0 ? emit(i - 2, i - 1, i, i) : emit(i - 1, i - 2, i, i);
      break;
  }
}

// Inverse transpose of the upper 3 x 3 up to a positive factor; defined for singular matrices too.
glm::mat3 normalMatrix(const Mat4 &worldFromObject) {
  const Vec3 x(worldFromObject[0]), y(worldFromObject[1]), z(worldFromObject[2]);
  const glm::mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < 0 ? -cofactors : cofactors;
}

// The matrix that skins a vertex: the sum of the palette's matrices by weight. [reference 4.7]
Mat4 blend(const DrawCall &call, size_t element) {
  Mat4 sum(0);
  for (size_t k = 0; k < std::min(call.matrixIndices.components, call.weights.components); ++k) {
    const float index = component(call.matrixIndices, element, k);
    if (index < static_cast<float>(call.palette.size())) {
      sum += component(call.weights, element, k) * call.palette[static_cast<size_t>(index)];
    }
  }
  return sum;
}

class Assembler {
 public:
  Assembler(const DrawCall &call, GeometrySet &set)
      : mCall(call), mSet(set), mNormalMatrix(normalMatrix(call.worldFromObject)) {
    for (const ArrayView *array : {&call.vertices, &call.normals, &call.texCoords, &call.colors}) {
      if (array->data) mElements = std::min(mElements, array->elements);
    }
    if (call.palette.empty()) return;
    mElements = std::min({mElements, call.matrixIndices.elements, call.weights.elements});
  }

  // A triangle of the draw call; `last` is the vertex that counts where shading is flat.
  void add(size_t i0, size_t i1, size_t i2, size_t last) {
    const size_t elements[3] = {loadIndex(mCall.indices, i0), loadIndex(mCall.indices, i1),
                                loadIndex(mCall.indices, i2)};
    const size_t shading = mCall.flatShading ? loadIndex(mCall.indices, last) : 0;
    for (const size_t element : {elements[0], elements[1], elements[2], shading}) {
      if (element >= mElements) return void(++mSet.skipped.noData);
    }
    Corner corners[3];
    for (size_t i = 0; i < 3; ++i) corners[i] = corner(elements[i], mCall.flatShading ? shading : elements[i]);
    const bool finite = isFinite(corners[0].position + corners[1].position + corners[2].position);
    if (mCall.clipPlanes.empty() || !finite) return addTriangle(corners[0], corners[1], corners[2]);
    const std::span<const Corner> left = mClipper.clip(corners, mCall.clipPlanes);
    if (left.empty()) ++mSet.skipped.clipped;
    for (size_t i = 2; i < left.size(); ++i) addTriangle(left[0], left[i - 1], left[i]);
  }

 private:
  Corner corner(size_t element, size_t shading) const {
    Corner corner{.position = position(element), .uv = texCoord(element)};
    if (mCall.normals.data) corner.normal = normal(shading);
    if (mCall.colors.data) corner.color = glm::clamp(loadColor(mCall.colors, shading), 0.0f, 1.0f);
    return corner;
  }

  void addTriangle(const Corner &a, const Corner &b, const Corner &c) {
    const Corner *corners[3] = {&a, &b, &c};
    hal::HotTriangle triangle{
        a.position, b.position, c.position, mCall.material, mCall.flags & ~uint32_t{hal::kTangentFrame}, 0};
    const Vec3 edges = glm::cross(b.position - a.position, c.position - a.position);
    if (!isFinite(a.position + b.position + c.position) || !isFinite(edges)) return void(++mSet.skipped.notFinite);
    // Without area as far as float can tell: the hit point would have no normal.
    if (!(glm::length(edges) > 0)) return void(++mSet.skipped.degenerate);

    hal::TriangleAttributes attributes{};
    for (size_t i = 0; i < 3; ++i) {
      attributes.uv[i] = corners[i]->uv;
      attributes.color[i] = corners[i]->color;
    }
    if (mCall.colors.data) triangle.flags |= hal::kHasColors;
    if (mCall.flags & hal::kTangentFrame) {
      if (setTangentFrame(triangle, edges, attributes)) triangle.flags |= hal::kTangentFrame;
    } else if (mCall.normals.data && setNormals(corners, edges, attributes)) {
      triangle.flags |= hal::kHasNormals;
    }
    mSet.triangles.push_back(triangle);
    mSet.attributes.push_back(attributes);
  }

  // The palette acts after the modelview matrix.
  Vec3 position(size_t element) const {
    const Vec4 world = mCall.worldFromObject * Vec4(loadVec3(mCall.vertices, element), 1);
    return Vec3(mCall.palette.empty() ? world : blend(mCall, element) * world);
  }

  Vec3 normal(size_t element) const {
    const Vec3 world = mNormalMatrix * loadVec3(mCall.normals, element);
    return mCall.palette.empty() ? world : normalMatrix(blend(mCall, element)) * world;
  }

  Vec2 texCoord(size_t element) const {
    const Vec4 given = mCall.texCoords.data ? Vec4(loadVec2(mCall.texCoords, element), 0, 1) : mCall.texCoord;
    const Vec4 coordinate = mCall.textureMatrix * given;
    const float q = coordinate.w != 0 ? coordinate.w : 1;
    return Vec2(coordinate) / q;
  }

  // False where no corner has a usable normal; a corner without one gets the flat normal.
  static bool setNormals(const Corner *const (&corners)[3], const Vec3 &edges, hal::TriangleAttributes &attributes) {
    const Vec3 flat = glm::normalize(edges);
    bool usable = false;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 given = corners[i]->normal;
      const bool valid = isFinite(given) && glm::length(given) > 0;
      attributes.normal[i] = valid ? normalizedOr(given, flat) : flat;
      usable |= valid;
    }
    return usable;
  }

  // Directions in which s and t grow, and the flat normal; false where the texture coordinates span nothing.
  // [reference 4.5]
  static bool setTangentFrame(const hal::HotTriangle &triangle, const Vec3 &edges,
                              hal::TriangleAttributes &attributes) {
    const Vec3 e1 = triangle.v1 - triangle.v0, e2 = triangle.v2 - triangle.v0;
    const Vec2 d1 = attributes.uv[1] - attributes.uv[0], d2 = attributes.uv[2] - attributes.uv[0];
    const float turn = d1.x * d2.y - d2.x * d1.y;
    if (turn == 0 || !std::isfinite(turn)) return false;
    const float sign = turn > 0 ? 1.0f : -1.0f;
    const Vec3 none(0);
    const Vec3 tangent = normalizedOr(sign * (d2.y * e1 - d1.y * e2), none);
    const Vec3 bitangent = normalizedOr(sign * (d1.x * e2 - d2.x * e1), none);
    if (tangent == none || bitangent == none) return false;
    attributes.normal[0] = tangent;
    attributes.normal[1] = bitangent;
    attributes.normal[2] = glm::normalize(edges);
    return true;
  }

  const DrawCall &mCall;
  GeometrySet &mSet;
  glm::mat3 mNormalMatrix;
  size_t mElements = SIZE_MAX;  // that every array has
  Clipper mClipper;
};

}  // namespace

void appendTriangles(const DrawCall &call, GeometrySet &set) {
  const size_t before = set.triangles.size();
  const SkippedTriangles skipped = set.skipped;
  try {
    Assembler assembler(call, set);
    forEachTriangle(call.primitive, call.indices.count,
                    [&](size_t i0, size_t i1, size_t i2, size_t last) { assembler.add(i0, i1, i2, last); });
  } catch (...) {  // out of memory: as if nothing had been drawn
    set.triangles.resize(before);
    set.attributes.resize(before);
    set.skipped = skipped;
    throw;
  }
  set.filtersShadow |= (call.flags & hal::kFiltersShadow) != 0;
}

}  // namespace rc::ddk
