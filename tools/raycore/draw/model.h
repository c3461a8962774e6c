// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// model.h: a scene as draw calls.
// In: Scene, Pose.  Out: rc* calls: materials and textures once, geometry for each pose.
#pragma once

#include <RC/rc.h>

#include <map>
#include <vector>

#include "draw/textures.h"
#include "scene/pose.h"
#include "scene/scene.h"

namespace rc::tool {

class Model {
 public:
  // Makes materials and textures in the current context; the scene's notes tell what was approximated.
  explicit Model(Scene &scene);

  // Which nodes: those that move, those that stay, or all.
  enum class Part { Moving, Standing, All };
  void draw(const Pose &pose, const std::vector<bool> &moving, Part part);

  // Of all textures, from now on.
  void setFilter(const TextureFilter &filter) const { mTextures.setFilter(filter); }
  // The file's name for one of RayCore's materials; empty if it is none of the model's.
  std::string materialName(RCuint name) const;

 private:
  struct Look {
    RCuint name = 0;
    bool textured = false, normals = false;
    Material material;
  };
  // Joints of a primitive as places in RayCore's palette, which is smaller than some skins.
  struct Bones {
    std::vector<Joints> joints;
    std::vector<uint32_t> used;
  };

  Look makeLook(const Material &material);
  const Look &lookOf(const Primitive &primitive) const;
  void drawNode(const Pose &pose, int index);
  void drawPrimitive(const Pose &pose, int index, const Primitive &primitive);
  void setSurfaceState(const Look &look, bool mirrored) const;
  void setCoordinates(const Primitive &primitive, const Look &look) const;
  void submit(const Pose &pose, int index, const Primitive &primitive);
  bool loadPalette(const Pose &pose, int skin, const Primitive &primitive);
  const Bones &bonesOf(const Primitive &primitive);

  Scene &mScene;
  Textures mTextures;
  std::vector<Look> mLooks;  // by material; the last one is for primitives without
  std::map<const Primitive *, Bones> mBones;
};

}  // namespace rc::tool
