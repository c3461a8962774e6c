// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/context.h"

#include <cstdarg>
#include <cstdio>
#include <utility>

#include "api/tokens.h"

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
  for (ddk::TextureUse &use : state.material0.textures) use.texture = mObjects->textures.bind(0);
  for (TextureBinding &binding : state.texture.bound) binding.texture = mObjects->textures.bind(0);
}

void Context::attach(DrawSurface *surface) {
  const std::lock_guard lock(mObjects->mutex);
  if (surface != mSurface) touch();
  mSurface = surface;
  if (!surface || std::exchange(mHadSurface, true)) return;
  const hal::Target target = surface->backBuffer();
  state.view.width = target.width;
  state.view.height = target.height;
}

void Context::finish() {
  const std::lock_guard lock(mObjects->mutex);
  if (scene.inStaticScene()) {
    scene.abandonStatic();
    touch();
    fail(RC_INVALID_OPERATION, "rcStaticSceneBegin without rcStaticSceneEnd; there is no static scene now");
  }
  if (!mSurface) return;
  const hal::Target target = mSurface->backBuffer();
  if (target.width != mWidth || target.height != mHeight) touch();
  if (mTraced == mObjects->changes) return;
  mLastFrame = mDriver.trace(frameState(), scene, target);
  mTraced = mObjects->changes;
  mWidth = target.width;
  mHeight = target.height;
  mSurface->traced();
  if (!scene.dynamics().empty()) resetMatrices();
  const ddk::FrameStats &f = mLastFrame;
  log(LogLevel::Frame,
      "frame %llu: %d x %d, %zu triangles (%zu static, %zu dynamic, %zu skipped), %llu rays (%llu primary, "
      "%llu shadow, %llu reflected, %llu refracted), build %.2f ms, trace %.2f ms",
      static_cast<unsigned long long>(++mFrame), f.width, f.height, f.staticTriangles + f.dynamicTriangles,
      f.staticTriangles, f.dynamicTriangles, f.skippedTriangles, static_cast<unsigned long long>(f.rays.all()),
      static_cast<unsigned long long>(f.rays.primary), static_cast<unsigned long long>(f.rays.shadow),
      static_cast<unsigned long long>(f.rays.reflected), static_cast<unsigned long long>(f.rays.refracted),
      f.buildMilliseconds, f.traceMilliseconds);
}

bool Context::pending() const {
  const std::lock_guard lock(mObjects->mutex);
  return mSurface && mTraced != mObjects->changes;
}

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
  frame.minWeight = minWeightOf(state.hints.rayBounceThreshold);
  return frame;
}

// Samples a pixel: those of the surface's configuration, but not fewer than the process or a hint asks for.
// RC_MULTISAMPLE, where it acts, switches the surface's.
int Context::samples() const {
  const int surface = mSurface ? mSurface->samples() : 1;
  return std::max({mSamples, surface, supersampled(state.hints.rendering) ? kNicestSamples : 1});
}

void Context::fail(RCenum error, const char *reason, ...) {
  if (mError == RC_NO_ERROR) mError = error;
  if (!logEnabled(LogLevel::Error)) return;
  char text[512];
  va_list arguments;
  va_start(arguments, reason);
  std::vsnprintf(text, sizeof text, reason, arguments);
  va_end(arguments);
  log(LogLevel::Error, "%s: %s: %s", mFunction, errorName(error), text);
}

RCenum Context::takeError() { return std::exchange(mError, RC_NO_ERROR); }

}  // namespace rc::api
