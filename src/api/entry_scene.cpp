// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: scenes and frames. [spec 3.7, 7; G 8, 9]
#include "RC/rc.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {
constexpr RCuint kDeepestBounce = 14;
}

extern "C" {

void rcSceneAllInit(void) {
  enter("rcSceneAllInit", [](Context &context) {
    context.scene.clear();
    rcBindMaterial(0);
    context.touch();
  });
}

void rcStaticSceneBegin(void) {
  enter("rcStaticSceneBegin", [](Context &context) {
    context.scene.beginStatic();
    context.touch();
  });
}

void rcStaticSceneEnd(void) {
  enter("rcStaticSceneEnd", [](Context &context) {
    if (!context.scene.inStaticScene()) return;
    context.scene.endStatic(context.driver().accelKind(), context.driver().workers());
    context.resetMatrices();
    context.touch();
  });
}

void rcFinish(void) {
  enter("rcFinish", [](Context &context) { context.finish(); });
}

void rcFlush(void) {
  enter("rcFlush", [](Context &context) { context.finish(); });
}

void rcDepthBounce(RCuint value) {
  enter("rcDepthBounce", [&](Context &context) {
    context.state.depthBounce = static_cast<int>(std::min(value, kDeepestBounce));
    context.touch();
  });
}

// The second generation's calls: no range is checked, as in the original. [reference 4.12]

void rcSetLightRadius(RCfloat radius) {
  enter("rcSetLightRadius", [&](Context &context) { context.state.pathTracing.lightRadius = radius; });
}

void rcSetDiffuseRate(RCuint rate) {
  enter("rcSetDiffuseRate", [&](Context &context) { context.state.pathTracing.diffuseRate = rate; });
}

void rcSetSPPCount(RCuint count) {
  enter("rcSetSPPCount", [&](Context &context) { context.state.pathTracing.sampleCount = count; });
}

}  // extern "C"
