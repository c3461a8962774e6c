// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: camera. [spec 3.1; G 2]
#include "RC/rcu.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

constexpr RCsizei kLargestViewport = 16384;  // larger ones are cut silently, as in GL

void setFrustum(Context &context, double l, double r, double b, double t, double zNear, double zFar) {
  // Written so that values which are not numbers fail too.
  if (!(zNear > 0) || !(zFar > 0) || zNear == zFar) {
    return context.fail(RC_INVALID_VALUE, "zNear %g and zFar %g must be above 0 and differ", zNear, zFar);
  }
  if (!(l < r || l > r) || !(b < t || b > t)) {
    return context.fail(RC_INVALID_VALUE, "left ... right is %g ... %g and bottom ... top %g ... %g: one is empty", l,
                        r, b, t);
  }
  if (!std::isfinite((r - l) + (t - b) + zNear))
    return context.fail(RC_INVALID_VALUE, "left, right, bottom, top or zNear is not finite");
  context.state.view.camera.window = {l, r, b, t, zNear, false};
  context.touch();
}

// Parallel rays; zNear may lie behind the viewer.
void setOrtho(Context &context, double l, double r, double b, double t, double zNear, double zFar) {
  if (!(l < r || l > r) || !(b < t || b > t) || !(zNear < zFar || zNear > zFar)) {
    return context.fail(RC_INVALID_VALUE,
                        "left ... right is %g ... %g, bottom ... top %g ... %g, zNear ... zFar %g ... %g: one is empty",
                        l, r, b, t, zNear, zFar);
  }
  if (!std::isfinite((r - l) + (t - b) + zNear))
    return context.fail(RC_INVALID_VALUE, "left, right, bottom, top or zNear is not finite");
  context.state.view.camera.window = {l, r, b, t, zNear, true};
  context.touch();
}

void setClearColor(Context &context, const Vec4 &colour) {
  for (int i = 0; i < 4; ++i) context.state.view.clearColor[i] = clamp01(colour[i]);
  context.touch();
}

void setLookAt(Context &context, const Vec3 &eye, const Vec3 &centre, const Vec3 &up) {
  const Vec3 none(0);
  const Vec3 back = normalizedOr(eye - centre, none);
  const Vec3 given = normalizedOr(up, none);
  const Vec3 right = normalizedOr(glm::cross(given, back), none);
  if (!isFinite(eye) || back == none || right == none) {
    return context.fail(RC_INVALID_VALUE,
                        "eyex ... and centerx ... must be finite and differ, and upx ... must point across the view");
  }
  ddk::Camera &camera = context.state.view.camera;
  camera.eye = eye;
  camera.right = right;
  camera.up = context.profile().perpendicularUp ? glm::cross(back, right) : given;
  camera.back = back;
  context.touch();
}

}  // namespace

extern "C" {

void rcViewport(RCint x, RCint y, RCsizei width, RCsizei height) {
  enter(Call("rcViewport", x, y, width, height), [&](Context &context) {
    if (width < 0 || height < 0)
      return context.fail(RC_INVALID_VALUE, "width x height is %d x %d, not 0 or more", width, height);
    ViewState &view = context.state.view;
    view.x = x;
    view.y = y;
    view.width = std::min(width, kLargestViewport);
    view.height = std::min(height, kLargestViewport);
    context.touch();
  });
}

void rcFrustum(RCdouble l, RCdouble r, RCdouble b, RCdouble t, RCdouble zNear, RCdouble zFar) {
  enter(Call("rcFrustum", l, r, b, t, zNear, zFar),
        [&](Context &context) { setFrustum(context, l, r, b, t, zNear, zFar); });
}

void rcFrustumf(RCfloat l, RCfloat r, RCfloat b, RCfloat t, RCfloat zNear, RCfloat zFar) {
  enter(Call("rcFrustumf", l, r, b, t, zNear, zFar),
        [&](Context &context) { setFrustum(context, l, r, b, t, zNear, zFar); });
}

void rcFrustumx(RCfixed l, RCfixed r, RCfixed b, RCfixed t, RCfixed zNear, RCfixed zFar) {
  enter(Call("rcFrustumx", l, r, b, t, zNear, zFar), [&](Context &context) {
    setFrustum(context, fromFixed(l), fromFixed(r), fromFixed(b), fromFixed(t), fromFixed(zNear), fromFixed(zFar));
  });
}

void rcOrtho(RCdouble l, RCdouble r, RCdouble b, RCdouble t, RCdouble zNear, RCdouble zFar) {
  enter(Call("rcOrtho", l, r, b, t, zNear, zFar),
        [&](Context &context) { setOrtho(context, l, r, b, t, zNear, zFar); });
}

void rcOrthof(RCfloat l, RCfloat r, RCfloat b, RCfloat t, RCfloat zNear, RCfloat zFar) {
  enter(Call("rcOrthof", l, r, b, t, zNear, zFar),
        [&](Context &context) { setOrtho(context, l, r, b, t, zNear, zFar); });
}

void rcOrthox(RCfixed l, RCfixed r, RCfixed b, RCfixed t, RCfixed zNear, RCfixed zFar) {
  enter(Call("rcOrthox", l, r, b, t, zNear, zFar), [&](Context &context) {
    setOrtho(context, fromFixed(l), fromFixed(r), fromFixed(b), fromFixed(t), fromFixed(zNear), fromFixed(zFar));
  });
}

void rcuPerspective(RCfloat fovy, RCfloat aspect, RCfloat zNear, RCfloat zFar) {
  enter(Call("rcuPerspective", fovy, aspect, zNear, zFar), [&](Context &context) {
    if (!(fovy > 0 && fovy < 180)) return context.fail(RC_INVALID_VALUE, "fovy is %g, not between 0 and 180", fovy);
    if (!(aspect > 0) || !std::isfinite(aspect))
      return context.fail(RC_INVALID_VALUE, "aspect is %g, not above 0 and finite", aspect);
    const ddk::Window window = ddk::Window::perspective(fovy, aspect, zNear);
    setFrustum(context, window.left, window.right, window.bottom, window.top, zNear, zFar);
  });
}

void rcuLookAt(RCfloat eyex, RCfloat eyey, RCfloat eyez, RCfloat centerx, RCfloat centery, RCfloat centerz, RCfloat upx,
               RCfloat upy, RCfloat upz) {
  enter(Call("rcuLookAt", eyex, eyey, eyez, centerx, centery, centerz, upx, upy, upz), [&](Context &context) {
    setLookAt(context, {eyex, eyey, eyez}, {centerx, centery, centerz}, {upx, upy, upz});
  });
}

void rcClearColor(RCclampf red, RCclampf green, RCclampf blue, RCclampf alpha) {
  enter(Call("rcClearColor", red, green, blue, alpha), [&](Context &context) {
    setClearColor(context, {red, green, blue, alpha});
  });
}

void rcClearColorx(RCclampx red, RCclampx green, RCclampx blue, RCclampx alpha) {
  enter(Call("rcClearColorx", red, green, blue, alpha), [&](Context &context) {
    setClearColor(context, {fromFixed(red), fromFixed(green), fromFixed(blue), fromFixed(alpha)});
  });
}

// Old programs call it between the parts of one frame and inside the static scene: it must drop nothing.
void rcClear(RCbitfield mask) {
  enter(Call("rcClear", mask), [](Context &) {});
}

}  // extern "C"
