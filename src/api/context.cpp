// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/context.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "api/tokens.h"
#include "api/trace.h"

namespace rc::api {
namespace {

constinit thread_local Context *tCurrent = nullptr;

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

Context *currentContext() { return tCurrent; }
void setCurrentContext(Context *context) { tCurrent = context; }

Context::Context(const Settings &settings, std::shared_ptr<SharedObjects> shared)
    : mProfile(profileNamed(settings.profile)),
      mSamples(settings.samples),
      mObjects(shared ? std::move(shared) : std::make_shared<SharedObjects>()),
      mDriver(settings) {
  state.light.lights.resize(size_t(mProfile.lights));
  state.depthBounce = mProfile.depthBounce;
  state.material0.specularLevel = mProfile.specularLevel;
  for (ddk::TextureUse &use : state.material0.textures) use.texture = mObjects->materials.texture0();
  for (TextureBinding &binding : state.texture.bound) binding.texture = mObjects->materials.texture0();
}

void Context::attach(DrawSurface *surface) {
  const bool first = surface && !mHadSurface;
  const hal::Target target = first ? surface->backBuffer() : hal::Target{};  // may run out of memory: before the rest
  if (surface != mSurface) mTraced = kNever;
  mSurface = surface;
  if (!first) return;
  mHadSurface = true;
  state.view.width = state.picture.scissorWidth = target.width;
  state.view.height = state.picture.scissorHeight = target.height;
}

void Context::finish() {
  const std::lock_guard lock(mObjects->mutex);
  if (scene.inStaticScene()) {
    scene.abandonStatic();
    touch();
    fail(RC_INVALID_OPERATION, "rcStaticSceneBegin without rcStaticSceneEnd; there is no static scene now");
    if (tracing()) traceLine("frame " + std::to_string(frameNumber()) + ": " + mFailure.reason);
  }
  if (!mSurface) return;
  const hal::Target target = mSurface->backBuffer();
  if (target.width != mWidth || target.height != mHeight) touch();
  if (mTraced == mObjects->changes) return;
  mLastFrame = mDriver.trace(frameState(), scene, target);
  mLastFrame.emptyDraws = std::exchange(mEmptyDraws, 0);
  mLastFrame.transformMilliseconds = std::exchange(mTransformMilliseconds, 0);
  mLastFrame.presentMilliseconds = std::exchange(mPresentMilliseconds, 0);
  mTraced = mObjects->changes;
  mWidth = target.width;
  mHeight = target.height;
  mSurface->traced();
  if (!scene.dynamics().empty()) resetMatrices();
  reportFrame();
  ++mFrame;
}

hal::Target Context::picture() {
  finish();
  return mSurface ? mSurface->backBuffer() : hal::Target{};
}

void Context::probe(const hal::PixelRect &part,
                    const std::function<void(int column, int row, const ddk::RayAnswer &answer)> &take) {
  finish();
  mDriver.probe(frameState(), scene, part, take);
}

AccelKind Context::accelKind() const { return structureOf(state.hints.structure).value_or(mDriver.accelKind()); }

bool Context::pending() const { return mSurface && mTraced != mObjects->changes; }

void Context::endFrame() {
  const std::lock_guard lock(mObjects->mutex);
  if (scene.endFrame()) touch();
}

void Context::resetMatrices() {
  if (mProfile.matricesPersist) return;
  state.matrices.modelview.current() = Mat4(1);
  state.matrices.texture.current() = Mat4(1);
}

ddk::FrameState Context::frameState() const {
  ddk::FrameState frame;
  frame.camera = state.view.camera.view(state.view.width, state.view.height, mProfile.centredFrustum);
  frame.clearColor = Rgb(state.view.clearColor);
  frame.materials = mObjects->materials.rows();
  frame.lights = state.light.lights;
  frame.lighting = state.light.lighting;
  frame.defaultLight = mProfile.defaultLightAtEye ? state.view.camera.eye : Vec3(0, 0, 1);
  frame.shadows = state.shadow.shadow;
  frame.colourShadow = state.shadow.colour;
  frame.mipmaps = state.hints.mipmap != RC_NICEST;
  frame.maxBounces = state.depthBounce;
  frame.samples = samples();
  frame.measure = mMeasuresUnits || logEnabled(LogLevel::Frame) || tracing();
  frame.adaptive = state.hints.rendering == RC_FASTEST_AND_NICEST;
  frame.minWeight = minWeightOf(state.hints.rayBounceThreshold);
  if (state.light.lighting) frame.globalAmbient = Rgb(state.light.modelAmbient);
  frame.fog = fogOf(state.fog);
  frame.scissor = scissorOf(state.picture);
  frame.writeMask = writeMaskOf(state.picture);
  frame.accelKind = accelKind();
  return frame;
}

// Those of the surface's configuration, but not fewer than the process asks for, which RC_MULTISAMPLE switches; or as
// many as a hint asks for.
int Context::samples() const {
  const int surface = mSurface ? mSurface->samples() : 1;
  const int plain = state.picture.multisample ? std::max(mSamples, surface) : 1;
  return supersampled(state.hints.rendering) ? std::max(plain, kNicestSamples) : plain;
}

void Context::reportFrame() const {
  if (!logEnabled(LogLevel::Frame) && !tracing()) return;
  const std::string line = "frame " + std::to_string(frameNumber()) + ": " + describe(mLastFrame);
  log(LogLevel::Frame, "%s", line.c_str());
  if (tracing()) traceLine(line);
}

void Context::fail(RCenum error, const char *reason, ...) {
  if (mError == RC_NO_ERROR) mError = error;
  mFailure.error = error;
  if (!logEnabled(LogLevel::Error) && !tracing() && !mDebugCallback.call) return;
  char text[512];
  va_list arguments;
  va_start(arguments, reason);
  std::vsnprintf(text, sizeof text, reason, arguments);
  va_end(arguments);
  try {
    mFailure.reason = withTokenNames(text);
  } catch (const std::bad_alloc &) {  // the error itself is what counts
    mFailure.reason.clear();
  }
  log(LogLevel::Error, "%s: %s: %s", mFunction, errorName(error), mFailure.reason.c_str());
  tellCallback();
}

// The message is that of the log; its id is the error.
void Context::tellCallback() {
  if (!mDebugCallback.call) return;
  char message[640];
  const int length = std::snprintf(message, sizeof message, "%s: %s: %s", mFunction, errorName(mFailure.error),
                                   mFailure.reason.c_str());
  mDebugCallback.call(RC_DEBUG_SOURCE_API, RC_DEBUG_TYPE_ERROR, mFailure.error, RC_DEBUG_SEVERITY_HIGH,
                      std::min(length, int(sizeof message) - 1), message, mDebugCallback.userParam);
}

RCenum Context::takeError() { return std::exchange(mError, RC_NO_ERROR); }

}  // namespace rc::api
