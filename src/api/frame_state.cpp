// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The state of a context as a frame needs it: hints and switches become numbers. [spec 3.1, 3.8]
#include <algorithm>

#include "api/call_trace.h"
#include "api/context.h"

namespace rc::api {
namespace {

// RC_RAYBOUNCE_THRESHOLD_HINT: secondary rays that count for less than (level + 1) / 100 are dropped.
float minWeightOf(RCenum hint) {
  return hint == RC_DONT_CARE ? 0 : static_cast<float>(hint - RC_THRESHOLD_LEVEL0 + 1) * 0.01f;
}

// Samples a pixel of RC_RENDERING_HINT.
constexpr int kNicestSamples = 4;
bool supersampled(RCenum hint) { return hint == RC_NICEST || hint == RC_FASTEST_AND_NICEST; }

// RC_STRUCTURE_HINT; nothing: as the process says.
std::optional<AccelKind> structureOf(RCenum hint) {
  constexpr AccelKind kKinds[] = {AccelKind::KdTree, AccelKind::Bvh, AccelKind::Exhaustive};
  if (hint == RC_DONT_CARE) return std::nullopt;
  return kKinds[hint - RC_STRUCTURE_KD_TREE];
}

hal::Fog fogOf(const FogState &state) {
  if (!state.enabled) return {};
  const hal::FogMode mode = state.mode == RC_LINEAR ? hal::FogMode::Linear
                            : state.mode == RC_EXP2 ? hal::FogMode::Exp2
                                                    : hal::FogMode::Exp;
  return {mode, state.density, state.start, state.end, Rgb(state.color)};
}

std::optional<hal::PixelRect> scissorOf(const PictureState &picture) {
  if (!picture.scissorTest) return std::nullopt;
  return hal::PixelRect{picture.scissorX, picture.scissorY, picture.scissorWidth, picture.scissorHeight};
}

// Bits of a pixel that may be written.
uint32_t writeMaskOf(const PictureState &picture) {
  uint32_t mask = 0;
  for (size_t channel = 0; channel < picture.colorMask.size(); ++channel) {
    if (picture.colorMask[channel]) mask |= 0xffu << 8 * channel;
  }
  return mask;
}

}  // namespace

AccelKind Context::accelKind() const { return structureOf(state.hints.structure).value_or(mDriver.accelKind()); }

ddk::FrameState Context::frameState() const {
  ddk::FrameState frame;
  frame.materials = mObjects->materials.rows();
  frame.lights = state.light.lights;
  frame.lighting = state.light.lighting;
  frame.defaultLight = mProfile.defaultLightAtEye ? state.view.camera.eye : Vec3(0, 0, 1);
  frame.colourShadow = state.shadow.colour;
  frame.accelKind = accelKind();
  hal::SceneView &view = frame.view;
  view.camera = state.view.camera.view(state.view.width, state.view.height, mProfile.centredFrustum);
  view.clearColor = Rgb(state.view.clearColor);
  view.shadows = state.shadow.shadow;
  view.mipmaps = state.hints.mipmap != RC_NICEST;
  view.maxBounces = state.depthBounce;
  view.samples = samples();
  view.measure = mMeasuresUnits || logEnabled(LogLevel::Frame) || tracing();
  view.adaptive = state.hints.rendering == RC_FASTEST_AND_NICEST;
  view.minWeight = minWeightOf(state.hints.rayBounceThreshold);
  if (state.light.lighting) view.globalAmbient = Rgb(state.light.modelAmbient);
  view.fog = fogOf(state.fog);
  view.scissor = scissorOf(state.picture);
  view.writeMask = writeMaskOf(state.picture);
  return frame;
}

// Those of the surface's configuration, but not fewer than the process asks for, which RC_MULTISAMPLE switches; or as
// many as a hint asks for.
int Context::samples() const {
  const int surface = mSurface ? mSurface->samples() : 1;
  const int plain = state.picture.multisample ? std::max(mSamples, surface) : 1;
  return supersampled(state.hints.rendering) ? std::max(plain, kNicestSamples) : plain;
}

}  // namespace rc::api
