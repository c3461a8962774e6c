// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/frame.h"

#include "rcddk/brightness.h"
#include "rchal/units/shadow_ray.h"

namespace rc::ddk {

Frame::Frame(const FrameState &state, Scene &scene)
    : mScene(scene), mDynamics(scene.dynamics()), mAccelKind(state.accelKind), mView(state.view) {
  rowsOf(state.materials, state.colourShadow, mNamed);
  rowsOf(scene.statics().captured, state.colourShadow, mStaticCaptured);
  rowsOf(mDynamics.captured, state.colourShadow, mDynamicCaptured);
  collectLights(state);

  mView.materials = mNamed;
  mView.textures = mTextures;
  mView.lights = mLights;
}

const hal::SceneView &Frame::view() {
  const auto viewOf = [](const GeometrySet &set, const Accel &accel, std::span<const hal::MaterialRow> captured) {
    return hal::GeometryView{set.triangles, set.attributes,    captured,
                             accel.view(),  set.filtersShadow, set.interpolates};
  };
  mView.geometry = {viewOf(mScene.statics(), mScene.staticAccel(), mStaticCaptured),
                    viewOf(mDynamics, mScene.dynamicAccel(), mDynamicCaptured)};
  Bounds most;  // of what lights shine on, without the little that reaches far out
  for (const hal::GeometryView &geometry : mView.geometry) most.add(geometry.accel.core);
  for (hal::LightRow &light : mLights) light.sendsShadowRays = hal::sendsShadowRays(light, most);
  mView.ignorable = ignorable(mView);
  return mView;
}

void Frame::rowsOf(std::span<const Material> materials, bool colourShadow, Array<hal::MaterialRow> &rows) {
  rows.reserve(materials.size());
  for (const Material &material : materials) {
    rows.push_back(materialRow(material, colourShadow));
    rows.back().texture = textureIndex(material.visibleTexture(kColourMap));
    rows.back().normalMap = textureIndex(material.visibleTexture(kNormalMap));
  }
}

int32_t Frame::textureIndex(const Texture *texture) {
  if (!texture) return hal::kNoTexture;
  const auto [place, isNew] = mIndices.try_emplace(texture, static_cast<int32_t>(mTextures.size()));
  if (isNew) {
    mTextures.push_back(texture->view());
    mImages.push_back(texture->image);
  }
  return place->second;
}

void Frame::collectLights(const FrameState &state) {
  for (const Light &light : state.lights) {
    if (state.lighting && light.enabled) mLights.push_back(lightRow(light));
  }
  mDefaultLight = mLights.empty();
  if (mDefaultLight) mLights.push_back(defaultLightRow(state.defaultLight));
}

}  // namespace rc::ddk
