// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// frame.h: all that a picture is made of, taken out of the state at one moment, so that the program may go on changing
// its state while the picture is traced. [spec 1, 3.7]
// In: FrameState, Scene.  Out: the SceneView of a device.  Next: rcddk/driver.cpp
#pragma once

#include <unordered_map>

#include "rcddk/camera.h"
#include "rcddk/light.h"
#include "rcddk/scene.h"

namespace rc::ddk {

// What of the state a frame depends on, besides the scene.
struct FrameState {
  hal::SceneView view;                  // without geometry, tables, and what follows from them
  std::span<const Material> materials;  // by name
  std::span<const Light> lights;
  bool lighting = false;
  Vec3 defaultLight{0};  // where the light is that shines when no other does
  bool colourShadow = true;
  AccelKind accelKind = AccelKind::Bvh;
};

class Frame {
 public:
  // Nothing of the state is needed any longer, but the scene must stay as it is.
  Frame(const FrameState &state, Scene &scene);
  Frame(const Frame &) = delete;
  Frame &operator=(const Frame &) = delete;

  Scene &scene() const { return mScene; }
  // The dynamic geometry that belongs to it.
  const GeometrySet &dynamics() const { return mDynamics; }
  AccelKind accelKind() const { return mAccelKind; }
  bool hasDefaultLight() const { return mDefaultLight; }
  // Once the structures are built. Valid as long as the frame is.
  const hal::SceneView &view();

 private:
  void rowsOf(std::span<const Material> materials, bool colourShadow, Array<hal::MaterialRow> &rows);
  int32_t textureIndex(const Texture *texture);
  void collectLights(const FrameState &state);

  Scene &mScene;
  const GeometrySet &mDynamics;
  AccelKind mAccelKind;
  hal::SceneView mView;
  // The tables that the view points into.
  Array<hal::MaterialRow> mNamed, mStaticCaptured, mDynamicCaptured;
  Array<hal::TextureView> mTextures;
  std::unordered_map<const Texture *, int32_t> mIndices;
  std::vector<std::shared_ptr<const Image>> mImages;  // whose texels they show
  std::vector<hal::LightRow> mLights;
  bool mDefaultLight = false;
};

}  // namespace rc::ddk
