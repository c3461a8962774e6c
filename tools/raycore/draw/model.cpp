// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/model.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "draw/surface.h"

namespace rc::tool {
namespace {

// Beside those of background and ground. [RC_MAX_MATERIALS]
constexpr size_t kMostMaterials = 508;
constexpr size_t kPaletteSize = 128;

void setMaterial(const Surface &surface) {
  const auto colour = [](RCenum name, const Vec3 &value) {
    const float values[] = {value.x, value.y, value.z, 1};
    rcMaterialfv(RC_FRONT_AND_BACK, name, values);
  };
  colour(RC_AMBIENT, surface.ambient);
  colour(RC_DIFFUSE, surface.diffuse);
  colour(RC_SPECULAR, surface.specular);
  colour(RC_EMISSION, surface.emission);
  colour(RC_REFLECTION, surface.reflection);
  colour(RC_TRANSMITTANCE, surface.transmittance);
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, surface.shininess);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, surface.refractionIndex);
}

void enable(RCenum cap, bool on) { (on ? rcEnable : rcDisable)(cap); }

template <class T>
void array(RCenum name, const std::vector<T> &values) {
  values.empty() ? rcDisableClientState(name) : rcEnableClientState(name);
}

// Colours of glTF's vertices are linear.
void encodeColours(Scene &scene) {
  for (Mesh &mesh : scene.meshes) {
    for (Primitive &primitive : mesh.primitives) {
      const bool classic = primitive.material >= 0 && scene.materials[size_t(primitive.material)].classic;
      for (Vec4 &c : primitive.colors) {
        if (!classic) c = Vec4(encoded(Vec3(c)), c.w);
        if (c.w < 1) scene.note("alpha of vertex colours: RayCore's vertices have none; not used");
      }
    }
  }
}

// [KHR_texture_transform]
Mat4 textureMatrix(const TextureUse &use) {
  return glm::translate(Mat4(1), Vec3(use.offset, 0)) * glm::rotate(Mat4(1), -use.rotation, Vec3(0, 0, 1)) *
         glm::scale(Mat4(1), Vec3(use.scale, 1));
}

}  // namespace

Model::Model(Scene &scene) : mScene(scene), mTextures(scene) {
  encodeColours(scene);
  for (size_t i = 0; i < scene.materials.size() && i < kMostMaterials; ++i) {
    const Material material = asDrawn(scene.materials[i]);
    noteApproximations(material, scene);
    mLooks.push_back(makeLook(material));
  }
  if (scene.materials.size() > kMostMaterials) {
    scene.note(
        fmt::format("{} materials: RayCore has {}; the rest are drawn grey", scene.materials.size(), kMostMaterials));
  }
  Material grey;
  grey.classic = grey.doubleSided = true;
  mLooks.push_back(makeLook(grey));
}

Model::Look Model::makeLook(const Material &material) {
  Look look{0, false, false, material};
  rcBindMaterial(0);
  rcGenMaterials(1, &look.name);
  rcBindMaterial(look.name);
  setMaterial(surfaceOf(material, averagesOf(mScene, material)));
  look.textured = mTextures.bindColour(material);
  look.normals = mTextures.bindNormals(material);
  return look;
}

std::string Model::materialName(RCuint name) const {
  for (size_t i = 0; i < mLooks.size(); ++i) {
    if (mLooks[i].name != name) continue;
    const std::string &own = mLooks[i].material.name;
    return i + 1 == mLooks.size() ? "(no material)" : own.empty() ? fmt::format("material {}", i) : own;
  }
  return {};
}

const Model::Look &Model::lookOf(const Primitive &primitive) const {
  const size_t index = size_t(primitive.material);
  return primitive.material >= 0 && index + 1 < mLooks.size() ? mLooks[index] : mLooks.back();
}

void Model::draw(const Pose &pose, const std::vector<bool> &moving, Part part) {
  for (const int index : mScene.order) {
    const bool wanted = part == Part::All || moving[size_t(index)] == (part == Part::Moving);
    if (wanted && mScene.nodes[size_t(index)].mesh >= 0) drawNode(pose, index);
  }
  rcMatrixMode(RC_TEXTURE);
  rcLoadIdentity();
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
}

void Model::drawNode(const Pose &pose, int index) {
  for (const Primitive &primitive : mScene.meshes[size_t(mScene.nodes[size_t(index)].mesh)].primitives) {
    if (!primitive.indices.empty()) drawPrimitive(pose, index, primitive);
  }
}

void Model::drawPrimitive(const Pose &pose, int index, const Primitive &primitive) {
  const Node &node = mScene.nodes[size_t(index)];
  const Look &look = lookOf(primitive);
  setCoordinates(primitive, look);
  const bool skinned = node.skin >= 0 && !primitive.joints.empty();
  const size_t copies = std::max<size_t>(node.instances.size(), 1);
  for (size_t i = 0; i < copies; ++i) {
    Mat4 place = skinned ? Mat4(1) : pose.world[size_t(index)];
    if (!node.instances.empty()) place *= node.instances[i];
    setSurfaceState(look, glm::determinant(glm::mat3(place)) < 0);
    rcMatrixMode(RC_MODELVIEW);
    rcLoadMatrixf(glm::value_ptr(place));
    submit(pose, index, primitive);
  }
}

// Surfaces with one side are not seen from behind, unless rays have to leave through that side.
void Model::setSurfaceState(const Look &look, bool mirrored) const {
  const Material &material = look.material;
  rcBindMaterial(look.name);
  const bool clear = material.classic ? maxOf(material.phong.transmittance) > 0 : material.transmission > 0;
  const bool holes = material.alphaMode != AlphaMode::Opaque;
  enable(RC_CULL_FACE, !material.classic && !material.doubleSided && !clear);
  rcFrontFace(mirrored ? RC_CW : RC_CCW);
  enable(RC_ALPHA_TEST, material.alphaMode == AlphaMode::Mask && look.textured);
  rcAlphaFunc(RC_GEQUAL, 1);
  enable(RC_USE_TEXTURE_ONLY, material.unlit && look.textured);
  enable(RC_USE_TRANSMITTANCE_SHADOW, clear);
  enable(RC_USE_TEXTURE_ALPHA_SHADOW, holes || material.classic);
}

void Model::setCoordinates(const Primitive &primitive, const Look &look) const {
  const TextureUse &use = Textures::placeOf(look.material);
  const std::vector<Vec2> &uvs = primitive.uvs[size_t(use.uvSet)];
  const bool wanted = (look.textured || look.normals) && !uvs.empty();
  wanted ? rcEnableClientState(RC_TEXTURE_COORD_ARRAY) : rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  if (wanted) rcTexCoordPointer(2, RC_FLOAT, 0, uvs.data());
  rcMatrixMode(RC_TEXTURE);
  rcLoadMatrixf(glm::value_ptr(textureMatrix(use)));
}

void Model::submit(const Pose &pose, int index, const Primitive &primitive) {
  const Node &node = mScene.nodes[size_t(index)];
  const std::vector<float> &weights = pose.weights[size_t(index)];
  const bool skinned = node.skin >= 0 && !primitive.joints.empty() && loadPalette(pose, node.skin, primitive);
  std::vector<Vec3> moved, turned;
  if (!primitive.targets.empty()) {
    moved = morphed(primitive.positions, primitive, weights, &MorphTarget::positions);
    turned = morphed(primitive.normals, primitive, weights, &MorphTarget::normals);
  }
  const std::vector<Vec3> &positions = moved.empty() ? primitive.positions : moved;
  const std::vector<Vec3> &normals = turned.empty() ? primitive.normals : turned;
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, positions.data());
  array(RC_NORMAL_ARRAY, normals);
  rcNormalPointer(RC_FLOAT, 0, normals.data());
  array(RC_COLOR_ARRAY, primitive.colors);
  rcColorPointer(4, RC_FLOAT, 0, primitive.colors.data());
  rcDrawElements(RC_TRIANGLES, RCsizei(primitive.indices.size()), RC_UNSIGNED_INT, primitive.indices.data());
  if (skinned) rcDisable(RC_MATRIX_PALETTE_OES);
}

const Model::Bones &Model::bonesOf(const Primitive &primitive) {
  const auto [entry, isNew] = mBones.try_emplace(&primitive);
  Bones &bones = entry->second;
  if (!isNew) return bones;
  std::map<uint32_t, uint32_t> places;
  bones.joints = primitive.joints;
  for (size_t i = 0; i < bones.joints.size(); ++i) {
    for (size_t k = 0; k < 4; ++k) {
      const bool counts = primitive.weights[i][int(k)] != 0;
      const uint32_t joint = counts ? primitive.joints[i][k] : primitive.joints[i][0];
      const auto [place, added] = places.try_emplace(joint, uint32_t(places.size()));
      if (added) bones.used.push_back(joint);
      bones.joints[i][k] = place->second;
    }
  }
  return bones;
}

// False, and drawn as it was modelled, if it needs more bones than there are places.
bool Model::loadPalette(const Pose &pose, int skin, const Primitive &primitive) {
  const Bones &bones = bonesOf(primitive);
  if (bones.used.size() > kPaletteSize) {
    mScene.note(
        fmt::format("a skin with {} bones: RayCore's palette has {}; not moved", bones.used.size(), kPaletteSize));
    return false;
  }
  const std::vector<Mat4> matrices = palette(mScene, pose, skin);
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  for (size_t i = 0; i < bones.used.size(); ++i) {
    rcCurrentPaletteMatrixOES(RCuint(i));
    rcLoadMatrixf(glm::value_ptr(matrices[bones.used[i]]));
  }
  rcMatrixMode(RC_MODELVIEW);
  rcMatrixIndexPointerOES(4, RC_UNSIGNED_INT, 0, bones.joints.data());
  rcWeightPointerOES(4, RC_FLOAT, 0, primitive.weights.data());
  return true;
}

}  // namespace rc::tool
