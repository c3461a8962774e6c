// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/driver.h"

#include <unordered_map>

#include "base/instruction_set.h"
#include "base/stopwatch.h"
#include "rcddk/brightness.h"

namespace rc::ddk {
namespace {

// The tables a SceneView points into, for the length of one frame.
class Snapshot {
 public:
  Snapshot(const FrameState &state, const Scene &scene) {
    rowsOf(state.materials, state.colourShadow, mNamed);
    rowsOf(scene.statics().captured, state.colourShadow, mStaticCaptured);
    rowsOf(scene.dynamics().captured, state.colourShadow, mDynamicCaptured);
    collectLights(state);

    mView.geometry = {geometryView(scene.statics(), mStaticCaptured), geometryView(scene.dynamics(), mDynamicCaptured)};
    mView.materials = mNamed;
    mView.textures = mTextures;
    mView.lights = mLights;
    mView.camera = state.camera;
    mView.clearColor = state.clearColor;
    mView.maxBounces = state.maxBounces;
    mView.samples = state.samples;
    mView.adaptive = state.adaptive;
    mView.measure = state.measure;
    mView.minWeight = state.minWeight;
    mView.globalAmbient = state.globalAmbient;
    mView.fog = state.fog;
    mView.scissor = state.scissor;
    mView.writeMask = state.writeMask;
    mView.shadows = state.shadows;
    mView.mipmaps = state.mipmaps;
    // Half a step of a byte.
    mView.ignorable = 0.5f / 256 / brightest(mView);
  }
  Snapshot(const Snapshot &) = delete;
  Snapshot &operator=(const Snapshot &) = delete;

  const hal::SceneView &view() const { return mView; }
  bool hasDefaultLight() const { return mDefaultLight; }

 private:
  void rowsOf(std::span<const Material> materials, bool colourShadow, Array<hal::MaterialRow> &rows) {
    rows.reserve(materials.size());
    for (const Material &material : materials) {
      rows.push_back(materialRow(material, colourShadow));
      rows.back().texture = textureIndex(material.visibleTexture(kColourMap));
      rows.back().normalMap = textureIndex(material.visibleTexture(kNormalMap));
    }
  }

  int32_t textureIndex(const Texture *texture) {
    if (!texture) return hal::kNoTexture;
    const auto [place, isNew] = mIndices.try_emplace(texture, static_cast<int32_t>(mTextures.size()));
    if (isNew) mTextures.push_back(texture->view());
    return place->second;
  }

  void collectLights(const FrameState &state) {
    for (const Light &light : state.lights) {
      if (state.lighting && light.enabled) mLights.push_back(lightRow(light));
    }
    mDefaultLight = mLights.empty();
    if (mDefaultLight) mLights.push_back(defaultLightRow(state.defaultLight));
  }

  static hal::GeometryView geometryView(const GeometrySet &set, std::span<const hal::MaterialRow> captured) {
    return {set.triangles, set.attributes, captured, set.accel.view(), set.filtersShadow};
  }

  Array<hal::MaterialRow> mNamed, mStaticCaptured, mDynamicCaptured;
  Array<hal::TextureView> mTextures;
  std::unordered_map<const Texture *, int32_t> mIndices;
  std::vector<hal::LightRow> mLights;
  bool mDefaultLight = false;
  hal::SceneView mView;
};

}  // namespace

Driver::Driver(const Settings &settings) : mAccelKind(settings.accel), mWorkers(settings.threads) {
  limitInstructionSet(settings.instructionSet);
  mDevice = hal::createDevice(settings.device, settings.threads);
  if (mDevice) return;
  log(LogLevel::Warning, "there is no device \"%s\"; \"cpu\" is used", settings.device.c_str());
  mDevice = hal::createDevice("cpu", settings.threads);
}

FrameStats Driver::trace(const FrameState &state, Scene &scene, const hal::Target &target) {
  FrameStats stats;
  const Stopwatch building;
  scene.buildDynamic(state.accelKind.value_or(mAccelKind), mWorkers);
  stats.buildMilliseconds = building.milliseconds();

  const Stopwatch tracing;
  const Snapshot snapshot(state, scene);
  stats.rays = mDevice->trace(snapshot.view(), target);
  stats.traceMilliseconds = tracing.milliseconds();
  stats.width = target.width;
  stats.height = target.height;
  stats.staticTriangles = scene.statics().triangles.size();
  stats.dynamicTriangles = scene.dynamics().triangles.size();
  stats.skipped = scene.statics().skipped + scene.dynamics().skipped;
  stats.lights = snapshot.view().lights.size();
  stats.defaultLight = snapshot.hasDefaultLight();
  return stats;
}

void Driver::probe(const FrameState &state, const Scene &scene, const hal::PixelRect &part,
                   const std::function<void(int column, int row, const RayAnswer &answer)> &take) {
  const Snapshot snapshot(state, scene);
  mWorkers.forEach(size_t(part.rows), [&](size_t row, int) {
    for (int column = part.column; column < part.column + part.columns; ++column) {
      take(column, part.row + int(row), probePixel(snapshot.view(), column, part.row + int(row)));
    }
  });
}

}  // namespace rc::ddk
