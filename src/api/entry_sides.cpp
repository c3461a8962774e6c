// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: which sides and texels of a surface are there, and flat shading. Each draw call captures them.
// [spec 3.8; OpenGL ES 1.1, 2.12.6, 3.5.1, 4.1.4]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

void setAlphaFunc(Context &context, RCenum func, float reference) {
  if (func < RC_NEVER || func > RC_ALWAYS)
    return context.fail(RC_INVALID_ENUM, "func 0x%04X is not one of RC_NEVER ... RC_ALWAYS", func);
  context.state.surface.alphaFunc = func;
  context.state.surface.alphaRef = clamp01(reference);
}

}  // namespace

extern "C" {

void rcAlphaFunc(RCenum func, RCclampf ref) {
  enter(Call("rcAlphaFunc", func, ref), [&](Context &context) { setAlphaFunc(context, func, ref); });
}

void rcAlphaFuncx(RCenum func, RCclampx ref) {
  enter(Call("rcAlphaFuncx", func, ref), [&](Context &context) { setAlphaFunc(context, func, fromFixed(ref)); });
}

void rcCullFace(RCenum mode) {
  enter(Call("rcCullFace", mode), [&](Context &context) {
    if (mode != RC_FRONT && mode != RC_BACK && mode != RC_FRONT_AND_BACK) {
      return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not RC_FRONT, RC_BACK or RC_FRONT_AND_BACK", mode);
    }
    context.state.surface.cullMode = mode;
  });
}

void rcFrontFace(RCenum mode) {
  enter(Call("rcFrontFace", mode), [&](Context &context) {
    if (mode != RC_CW && mode != RC_CCW)
      return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not RC_CCW or RC_CW", mode);
    context.state.surface.frontFace = mode;
  });
}

void rcShadeModel(RCenum mode) {
  enter(Call("rcShadeModel", mode), [&](Context &context) {
    if (mode != RC_FLAT && mode != RC_SMOOTH) {
      return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not RC_FLAT or RC_SMOOTH", mode);
    }
    context.state.surface.shadeModel = mode;
  });
}

}  // extern "C"
