// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/context.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "api/call_trace.h"
#include "api/tokens.h"
#include "base/stopwatch.h"

namespace rc::api {
namespace {

constinit thread_local Context *tCurrent = nullptr;

}  // namespace

Context *currentContext() { return tCurrent; }
void setCurrentContext(Context *context) { tCurrent = context; }

Context::Context(const Settings &settings, std::shared_ptr<SharedObjects> shared)
    : mProfile(profileNamed(settings.profile)),
      mSamples(settings.samples),
      mPipelines(settings.pipeline),
      mObjects(shared ? std::move(shared) : std::make_shared<SharedObjects>()),
      mDriver(settings),
      mBackground(mDriver.workers()) {
  state.light.lights.resize(size_t(mProfile.lights));
  state.depthBounce = mProfile.depthBounce;
  state.material0.specularLevel = mProfile.specularLevel;
  for (ddk::TextureUse &use : state.material0.textures) use.texture = mObjects->materials.texture0();
  for (TextureBinding &binding : state.texture.bound) binding.texture = mObjects->materials.texture0();
}

void Context::attach(DrawSurface *surface) {
  const bool first = surface && !mHadSurface;
  const hal::Target target = first ? surface->backBuffer() : hal::Target{};  // may run out of memory: before the rest
  if (surface != mSurface) {
    awaitPicture();
    mTraced = mEnded = kNever;
  }
  mSurface = surface;
  if (!first) return;
  mHadSurface = true;
  state.view.width = state.picture.scissorWidth = target.width;
  state.view.height = state.picture.scissorHeight = target.height;
}

void Context::finish() {
  const std::lock_guard lock(mObjects->mutex);
  await();
  const std::unique_ptr<Picture> picture = beginPicture();
  if (!picture) return;
  try {
    trace(*picture);
  } catch (...) {
    pictureFailed();
    throw;
  }
  mLastFrame = picture->stats;
}

void Context::finishAndShow(std::function<void()> showIt) {
  const std::lock_guard lock(mObjects->mutex);
  if (!mPipelines || !mBackground.possible() || tracing()) {
    finish();
    show(showIt);
  } else {
    await();
    std::function<void()> job = [this, showIt = std::move(showIt)] { makePicture(showIt); };
    mOnItsWay = beginPicture();
    mLost = true;
    mBackground.begin(std::move(job));
    scene.lend();
  }
  endFrame();
}

void Context::await() {
  const std::lock_guard lock(mObjects->mutex);
  awaitPicture();
  scene.giveBack();
  const std::unique_ptr<Picture> made = std::move(mOnItsWay);
  if (std::exchange(mLost, false)) {
    pictureFailed();
    fail(RC_OUT_OF_MEMORY, "there was not enough memory for the frame before");
  } else if (made) {
    mLastFrame = made->stats;
  }
}

// In the background.
void Context::makePicture(const std::function<void()> &showIt) noexcept {
  try {
    if (mOnItsWay) trace(*mOnItsWay);
    show(showIt);
    mLost = false;
  } catch (const std::exception &) {  // whoever uses what it is made of is told
  }
}

std::unique_ptr<Context::Picture> Context::beginPicture() {
  try {
    return nextPicture();
  } catch (...) {
    if (mSurface) mSurface->failed();
    throw;
  }
}

// Nothing where the last picture shows all there is.
std::unique_ptr<Context::Picture> Context::nextPicture() {
  if (scene.inStaticScene()) abandonStaticScene();
  if (!mSurface) return nullptr;
  const hal::Target target = mSurface->backBuffer();
  if (target.width != mWidth || target.height != mHeight) touch();
  if (mTraced == mObjects->changes) return nullptr;
  auto picture = std::make_unique<Picture>(frameState(), scene);
  mSurface->asked();
  // There is memory for all of it.
  picture->build = scene.beginFrame();
  picture->surface = mSurface;
  picture->target = target;
  picture->number = ++mFrame;
  picture->stats.emptyDraws = std::exchange(mEmptyDraws, 0);
  picture->stats.transformMilliseconds = std::exchange(mTransformMilliseconds, 0);
  picture->stats.presentMilliseconds = std::exchange(mPresentMilliseconds, 0);
  mTraced = mObjects->changes;
  mWidth = target.width;
  mHeight = target.height;
  if (picture->build && !scene.dynamics().empty()) resetMatrices();  // once a frame, however often it is traced
  return picture;
}

void Context::abandonStaticScene() {
  scene.abandonStatic();
  touch();
  fail(RC_INVALID_OPERATION, "rcStaticSceneBegin without rcStaticSceneEnd; there is no static scene now");
  if (tracing()) traceLine("frame " + std::to_string(frameNumber()) + ": " + mFailure.reason);
}

void Context::trace(Picture &picture) {
  try {
    mDriver.trace(picture.frame, picture.build, picture.target, picture.stats);
  } catch (...) {
    picture.surface->failed();
    throw;
  }
  picture.surface->traced();
  report(picture);
}

void Context::show(const std::function<void()> &show) {
  const Stopwatch watch;
  show();
  mPresentMilliseconds = watch.milliseconds();
}

// It is asked for again.
void Context::pictureFailed() {
  mTraced = mEnded = kNever;
  scene.abandonFrame();
}

void Context::complete() {
  const std::lock_guard lock(mObjects->mutex);
  mSurface &&mEnded != mChanges ? finish() : await();
}

hal::Target Context::picture() {
  complete();
  return mSurface ? mSurface->backBuffer() : hal::Target{};
}

void Context::probe(const hal::PixelRect &part,
                    const std::function<void(int column, int row, const ddk::RayAnswer &answer)> &take) {
  finish();
  ddk::Frame frame(frameState(), scene);
  mDriver.probe(frame, part, take);
}

bool Context::pending() const { return mSurface && mTraced != mObjects->changes && mEnded != mChanges; }

void Context::endFrame() {
  const std::lock_guard lock(mObjects->mutex);
  const bool complete = mTraced == mObjects->changes;
  if (scene.endFrame()) touch();
  if (complete) mEnded = mChanges;
}

void Context::resetMatrices() {
  if (mProfile.matricesPersist) return;
  state.matrices.modelview.current() = Mat4(1);
  state.matrices.texture.current() = Mat4(1);
}

void Context::report(const Picture &picture) {
  if (!logEnabled(LogLevel::Frame) && !tracing()) return;
  const std::string line = "frame " + std::to_string(picture.number) + ": " + describe(picture.stats);
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
