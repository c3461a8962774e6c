// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "foreign/convert.h"

namespace rc::tool::foreign {
namespace {

std::vector<Vec3> vectors(const aiVector3D *from, unsigned count) {
  std::vector<Vec3> to;
  if (!from) return to;
  to.reserve(count);
  for (unsigned i = 0; i < count; ++i) to.push_back(asVec3(from[i]));
  return to;
}

// Loaders may leave NaN for vertices without a normal or a coordinate.
bool usable(const std::vector<Vec3> &normals) {
  for (const Vec3 &n : normals) {
    if (glm::any(glm::isnan(n))) return false;
  }
  return true;
}

Primitive primitiveFrom(const aiMesh &from, Scene &to) {
  Primitive primitive;
  const unsigned count = from.mNumVertices;
  primitive.positions = vectors(from.mVertices, count);
  primitive.normals = vectors(from.mNormals, count);
  if (!usable(primitive.normals)) primitive.normals.clear();
  for (size_t set = 0; set < primitive.uvs.size(); ++set) {
    for (const Vec3 &uv : vectors(from.mTextureCoords[set], count)) primitive.uvs[set].push_back(Vec2(uv));
  }
  for (unsigned i = 0; from.mColors[0] && i < count; ++i) {
    const aiColor4D &c = from.mColors[0][i];
    primitive.colors.push_back({c.r, c.g, c.b, c.a});
  }
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace &face = from.mFaces[i];
    if (face.mNumIndices != 3) {
      to.note("points and lines: rays meet surfaces only; not drawn");
      continue;
    }
    const unsigned *corners = face.mIndices;
    if (std::max({corners[0], corners[1], corners[2]}) >= count) continue;
    primitive.indices.insert(primitive.indices.end(), corners, corners + 3);
  }
  primitive.material = from.mMaterialIndex < to.materials.size() ? int(from.mMaterialIndex) : -1;
  return primitive;
}

void addTargets(const aiMesh &from, Primitive &primitive) {
  for (unsigned t = 0; t < from.mNumAnimMeshes; ++t) {
    const aiAnimMesh &target = *from.mAnimMeshes[t];
    std::vector<Vec3> moved = vectors(target.mVertices, target.mNumVertices);
    if (moved.size() != primitive.positions.size()) continue;
    for (size_t i = 0; i < moved.size(); ++i) moved[i] -= primitive.positions[i];
    primitive.targets.push_back({std::move(moved), {}});
  }
}

}  // namespace

void convertMeshes(const aiScene &from, Scene &to) {
  for (unsigned i = 0; i < from.mNumMeshes; ++i) {
    const aiMesh &mesh = *from.mMeshes[i];
    Mesh result{mesh.mName.C_Str(), {primitiveFrom(mesh, to)}, {}};
    addTargets(mesh, result.primitives[0]);
    to.meshes.push_back(std::move(result));
  }
}

}  // namespace rc::tool::foreign
