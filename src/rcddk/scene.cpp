// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/scene.h"

#include <utility>

#include "base/stopwatch.h"

namespace rc::ddk {
namespace {

// Empties the set but keeps its memory: the next frame will be about as large.
void recycle(GeometrySet &set) {
  set.triangles.clear();
  set.attributes.clear();
  set.captured.clear();
  set.skipped = {};
  set.filtersShadow = set.interpolates = false;
}

}  // namespace

void Scene::clear() {
  abandonStatic();
  mDynamics = {};
  mDynamicAccel = {};
  mDynamicsTraced = false;
}

void Scene::beginStatic() {
  abandonStatic();
  mInStaticScene = true;
}

void Scene::endStatic(AccelKind kind, const Workers &workers) {
  const Stopwatch building;
  try {
    mStatics.triangles.shrink_to_fit();  // it stays as it is
    mStatics.attributes.shrink_to_fit();
    mStaticAccel = buildAccel(kind, mStatics.triangles, workers);
  } catch (...) {  // out of memory: better no static scene than one without a structure
    abandonStatic();
    throw;
  }
  mStaticBuildMilliseconds = building.milliseconds();
  mInStaticScene = false;
}

void Scene::abandonStatic() {
  mStatics = {};
  mStaticAccel = {};
  mInStaticScene = false;
}

GeometrySet &Scene::target() {
  if (mInStaticScene) return mStatics;
  if (mDynamicsTraced) startNextFrame();
  return mDynamics[mMaking];
}

bool Scene::beginFrame() { return !std::exchange(mDynamicsTraced, true); }

// The structure of the frame before is where this one's begins: the triangles may be the same ones, moved.
void Scene::buildDynamic(const GeometrySet &dynamics, AccelKind kind, const Workers &workers) {
  if (mDynamicAccel.kind == kind && refit(dynamics.triangles, workers, mDynamicAccel)) return;
  Accel old = std::exchange(mDynamicAccel, {});  // what is left without memory must not look like a tree
  mDynamicAccel = buildAccel(kind, dynamics.triangles, workers, Lifetime::Frame, std::move(old));
}

bool Scene::endFrame() {
  const bool had = mDynamicsTraced && !dynamics().empty();
  if (mDynamicsTraced) startNextFrame();
  return had;
}

void Scene::startNextFrame() {
  if (mLent) mMaking = 1 - mMaking;
  recycle(mDynamics[mMaking]);
  mDynamicsTraced = false;
}

}  // namespace rc::ddk
