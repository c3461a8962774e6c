// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// convert.h: the parts of Assimp's scene, each as ours.
#pragma once

#include <assimp/scene.h>

#include <map>
#include <string>

#include "scene/scene.h"

namespace rc::tool::foreign {

inline Vec3 asVec3(const aiVector3D &v) { return {v.x, v.y, v.z}; }
inline Vec3 asVec3(const aiColor3D &c) { return {c.r, c.g, c.b}; }
// Assimp's matrices are row by row.
inline Mat4 asMat4(const aiMatrix4x4 &m) {
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

using NodeNames = std::map<std::string, int>;

// Adds a node behind all others, and to the children of its parent if it has one; its number.
int append(Node node, Scene &to);
// folder: where pictures are looked for.
void convertMaterials(const aiScene &from, const std::string &folder, Scene &to);
void convertMeshes(const aiScene &from, Scene &to);
// One node for each of Assimp's, and one more for each mesh of it.
NodeNames convertNodes(const aiScene &from, Scene &to);
// Bones and animations name nodes. Meshes were converted in order: node.mesh is Assimp's index.
void convertSkins(const aiScene &from, const NodeNames &names, Scene &to);
void convertAnimations(const aiScene &from, const NodeNames &names, Scene &to);
void convertViews(const aiScene &from, const NodeNames &names, Scene &to);  // cameras and lights

}  // namespace rc::tool::foreign
