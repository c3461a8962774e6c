// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "foreign/convert.h"

namespace rc::tool::foreign {
namespace {

void place(const aiMatrix4x4 &matrix, Node &node) {
  node.hasMatrix = true;
  node.matrix = asMat4(matrix);
  aiVector3D scale, position;
  aiQuaternion rotation;
  matrix.Decompose(scale, rotation, position);
  node.translation = asVec3(position);
  node.scale = asVec3(scale);
  node.rotation = Quat(rotation.w, rotation.x, rotation.y, rotation.z);
}

}  // namespace

int append(Node node, Scene &to) {
  const int index = static_cast<int>(to.nodes.size());
  if (node.parent >= 0) to.nodes[size_t(node.parent)].children.push_back(index);
  to.nodes.push_back(std::move(node));
  to.order.push_back(index);
  return index;
}

NodeNames convertNodes(const aiScene &from, Scene &to) {
  NodeNames names;
  std::vector<std::pair<const aiNode *, int>> waiting{{from.mRootNode, -1}};
  while (!waiting.empty()) {
    const auto [about, parent] = waiting.back();
    waiting.pop_back();
    Node node;
    node.name = about->mName.C_Str();
    node.parent = parent;
    place(about->mTransformation, node);
    const int index = append(node, to);
    names.emplace(node.name, index);
    for (unsigned i = 0; i < about->mNumMeshes; ++i) {
      Node carrier;
      carrier.parent = index;
      carrier.mesh = static_cast<int>(about->mMeshes[i]);
      append(std::move(carrier), to);
    }
    for (unsigned i = about->mNumChildren; i-- > 0;) waiting.push_back({about->mChildren[i], index});
  }
  return names;
}

}  // namespace rc::tool::foreign
