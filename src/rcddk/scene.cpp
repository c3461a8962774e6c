// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddk/scene.h"

#include <utility>

#include "base/stopwatch.h"

namespace rc::ddk {
namespace {

// Empties the set but keeps its memory: the next frame will be about as large. The structure stays too: the next
// frame's triangles may be the same ones, moved.
void recycle(GeometrySet &set) {
  set.triangles.clear();
  set.attributes.clear();
  set.captured.clear();
  set.skipped = {};
  set.filtersShadow = false;
}

}  // namespace

void Scene::clear() {
  mStatics = {};
  mDynamics = {};
  mInStaticScene = mDynamicsTraced = false;
}

void Scene::beginStatic() {
  mStatics = {};
  mInStaticScene = true;
}

void Scene::endStatic(AccelKind kind, const Workers &workers) {
  const Stopwatch building;
  try {
    mStatics.accel = buildAccel(kind, mStatics.triangles, workers);
  } catch (...) {  // out of memory: better no static scene than one without a structure
    abandonStatic();
    throw;
  }
  mStaticBuildMilliseconds = building.milliseconds();
  mInStaticScene = false;
}

void Scene::abandonStatic() {
  mStatics = {};
  mInStaticScene = false;
}

GeometrySet &Scene::target() {
  if (mInStaticScene) return mStatics;
  if (mDynamicsTraced) recycle(mDynamics);
  mDynamicsTraced = false;
  return mDynamics;
}

void Scene::buildDynamic(AccelKind kind, const Workers &workers) {
  const bool sameKind = mDynamics.accel.kind == kind;
  if (!mDynamicsTraced && !(sameKind && refit(mDynamics.triangles, workers, mDynamics.accel))) {
    Accel old = std::exchange(mDynamics.accel, {});  // what is left without memory must not look like a tree
    mDynamics.accel = buildAccel(kind, mDynamics.triangles, workers, Lifetime::Frame, std::move(old));
  }
  mDynamicsTraced = true;
}

bool Scene::endFrame() {
  const bool had = mDynamicsTraced && !mDynamics.empty();
  if (mDynamicsTraced) recycle(mDynamics);
  mDynamicsTraced = false;
  return had;
}

}  // namespace rc::ddk
