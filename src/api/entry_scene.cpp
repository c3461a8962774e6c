// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: scenes and frames. [spec 3.7, 7; G 8, 9]
#include "RC/rc.h"
#include "api/guard.h"
#include "api/material_binding.h"

using namespace rc;
using namespace rc::api;

namespace {
constexpr RCuint kDeepestBounce = 14;
}

extern "C" {

void rcSceneAllInit(void) {
  enter(Call("rcSceneAllInit"), [](Context &context) {
    context.await();
    context.scene.clear();
    bindMaterial(context, 0);
    context.touch();
  });
}

void rcStaticSceneBegin(void) {
  enter(Call("rcStaticSceneBegin"), [](Context &context) {
    context.await();
    context.scene.beginStatic();
    context.touch();
  });
}

void rcStaticSceneEnd(void) {
  enter(Call("rcStaticSceneEnd"), [](Context &context) {
    if (!context.scene.inStaticScene()) return;
    context.await();
    context.scene.endStatic(context.accelKind(), context.driver().workers());
    context.resetMatrices();
    context.touch();
  });
}

void rcFinish(void) {
  enter(Call("rcFinish"), [](Context &context) { context.finish(); });
}

void rcFlush(void) {
  enter(Call("rcFlush"), [](Context &context) { context.finish(); });
}

void rcDepthBounce(RCuint value) {
  enter(Call("rcDepthBounce", value), [&](Context &context) {
    context.state.depthBounce = static_cast<int>(std::min(value, kDeepestBounce));
    context.touch();
  });
}

// The second generation's calls: no range is checked, as in the original. [reference 4.12]

void rcSetLightRadius(RCfloat radius) {
  enter(Call("rcSetLightRadius", radius), [&](Context &context) { context.state.pathTracing.lightRadius = radius; });
}

void rcSetDiffuseRate(RCuint rate) {
  enter(Call("rcSetDiffuseRate", rate), [&](Context &context) { context.state.pathTracing.diffuseRate = rate; });
}

void rcSetSPPCount(RCuint count) {
  enter(Call("rcSetSPPCount", count), [&](Context &context) { context.state.pathTracing.sampleCount = count; });
}

}  // extern "C"
