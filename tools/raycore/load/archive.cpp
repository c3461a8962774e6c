// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "load/archive.h"

namespace rc::tool {
namespace {

// One list of members for each type, for writing and for reading.
template <class Archive, class... Members>
void each(Archive &archive, Members &...members);

// Declared before the lists that hold them.
template <class Archive>
void item(Archive &archive, Image &);
template <class Archive>
void item(Archive &archive, MorphTarget &);
template <class Archive>
void item(Archive &archive, Primitive &);
template <class Archive>
void item(Archive &archive, Mesh &);
template <class Archive>
void item(Archive &archive, Skin &);
template <class Archive>
void item(Archive &archive, Node &);
template <class Archive>
void item(Archive &archive, Channel &);
template <class Archive>
void item(Archive &archive, Animation &);
template <class Archive>
void item(Archive &archive, Camera &);
template <class Archive>
void item(Archive &archive, Light &);
template <class Archive>
void item(Archive &archive, Material &);

template <class Archive>
void item(Archive &a, std::string &text) {
  a.plain(text);
}
template <class Archive, class T>
void item(Archive &a, std::vector<T> &items) {
  if constexpr (std::is_trivially_copyable_v<T>) {
    a.plain(items);
  } else {
    a.resize(items);
    for (T &one : items) item(a, one);
  }
}
template <class Archive>
void item(Archive &a, Image &x) {
  each(a, x.name, x.width, x.height, x.rgba);
}
template <class Archive>
void item(Archive &a, MorphTarget &x) {
  each(a, x.positions, x.normals);
}
template <class Archive>
void item(Archive &a, Primitive &x) {
  each(a, x.positions, x.normals, x.colors, x.uvs[0], x.uvs[1], x.joints, x.weights, x.indices, x.targets, x.material);
}
template <class Archive>
void item(Archive &a, Mesh &x) {
  each(a, x.name, x.primitives, x.weights);
}
template <class Archive>
void item(Archive &a, Skin &x) {
  each(a, x.name, x.joints, x.inverseBind);
}
template <class Archive>
void item(Archive &a, Node &x) {
  each(a, x.name, x.parent, x.mesh, x.skin, x.camera, x.light, x.children, x.hasMatrix, x.matrix, x.translation,
       x.scale, x.rotation, x.weights, x.instances);
}
template <class Archive>
void item(Archive &a, Channel &x) {
  each(a, x.node, x.path, x.interpolation, x.times, x.values, x.width);
}
template <class Archive>
void item(Archive &a, Animation &x) {
  each(a, x.name, x.channels);
}
template <class Archive>
void item(Archive &a, Camera &x) {
  each(a, x.name, x.orthographic, x.yfov, x.xmag, x.ymag, x.znear);
}
template <class Archive>
void item(Archive &a, Light &x) {
  each(a, x.name, x.kind, x.color, x.intensity, x.range, x.innerCone, x.outerCone);
}
template <class Archive>
void item(Archive &a, Material &x) {
  each(a, x.name, x.classic, x.phong, x.baseColor, x.metallic, x.roughness, x.emissive, x.ior, x.transmission,
       x.thickness, x.attenuationColor, x.attenuationDistance, x.specular, x.specularColor, x.baseTexture,
       x.metallicRoughnessTexture, x.normalTexture, x.emissiveTexture, x.transmissionTexture, x.normalScale,
       x.alphaMode, x.alphaCutoff, x.doubleSided, x.unlit);
}
template <class Archive>
void item(Archive &a, Scene &x) {
  each(a, x.format, x.images, x.textures, x.materials, x.meshes, x.skins, x.nodes, x.order, x.animations, x.cameras,
       x.lights, x.notes, x.zUp);
}

template <class Archive, class Member>
void one(Archive &archive, Member &member) {
  if constexpr (std::is_trivially_copyable_v<Member>) {
    archive.value(member);
  } else {
    item(archive, member);
  }
}
template <class Archive, class... Members>
void each(Archive &archive, Members &...members) {
  (one(archive, members), ...);
}

}  // namespace

std::string packed(const Scene &scene) {
  Writer writer;
  item(writer, const_cast<Scene &>(scene));  // the writer only reads
  return writer.take();
}

Scene unpacked(std::string_view bytes) {
  Reader reader(bytes);
  Scene scene;
  item(reader, scene);
  return scene;
}

}  // namespace rc::tool
