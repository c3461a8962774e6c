// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// textures.h: textures of the scene -> RayCore's.
#pragma once

#include <RC/rc.h>

#include <map>
#include <tuple>

#include "scene/scene.h"

namespace rc::tool {

// RC_LINEAR_MIPMAP_LINEAR or another filter, and how many samples lie side by side where a texture is seen at a slant:
// four bring most of what there is, for an eighth of a frame's time.
struct TextureFilter {
  RCint minFilter = RC_LINEAR_MIPMAP_LINEAR;
  RCint anisotropy = 4;
};

class Textures {
 public:
  explicit Textures(const Scene &scene) : mScene(scene) {}

  // Binds what the material shows, if it shows a texture, into the bound material; false if it shows none.
  bool bindColour(const Material &material);
  bool bindNormals(const Material &material);

  // How all of them are read from now on.
  void setFilter(const TextureFilter &filter) const;

  // The coordinates they use.
  static const TextureUse &placeOf(const Material &material);

 private:
  const Image &imageOf(const TextureUse &use) const;
  Image colourOf(const Material &material) const;
  void upload(RCenum target, const Image &image, const Texture &texture, RCint opaqueAlpha);

  struct Uploaded {
    RCenum target;
    RCuint name;
  };

  const Scene &mScene;
  std::vector<Uploaded> mUploaded;
};

}  // namespace rc::tool
