// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scene.h: the static scene and the frame's dynamic geometry, and how long each lives. [spec 3.7; G 9]
#pragma once

#include <array>

#include "rcddk/geometry.h"

namespace rc::ddk {

class Scene {
 public:
  const GeometrySet &statics() const { return mStatics; }
  // Of the frame that is being made, or of the one that was traced last.
  const GeometrySet &dynamics() const { return mDynamics[mMaking]; }
  const Accel &staticAccel() const { return mStaticAccel; }
  const Accel &dynamicAccel() const { return mDynamicAccel; }
  bool inStaticScene() const { return mInStaticScene; }
  // Of the structure of the static scene.
  double staticBuildMilliseconds() const { return mStaticBuildMilliseconds; }

  // Drops everything. [rcSceneAllInit]
  void clear();

  // The new static scene replaces the old one at once.
  void beginStatic();
  // Builds the structure.
  void endStatic(AccelKind kind, const Workers &workers);
  // A begin whose end is missing: there is no static scene.
  void abandonStatic();

  // Where a draw call's triangles go. The first ones after a traced frame begin the next frame.
  GeometrySet &target();
  // Whether target() ends a traced frame, whose dynamic geometry is gone then.
  bool drawEndsFrame() const { return mDynamicsTraced && !mInStaticScene; }

  // The frame is traced from now on: its dynamic geometry is complete. Whether a structure must be built for it.
  bool beginFrame();
  // Builds it for that geometry, which nothing but a frame that was begun may ask for.
  void buildDynamic(const GeometrySet &dynamics, AccelKind kind, const Workers &workers);
  // There was no memory for it: it is not traced.
  void abandonFrame() { mDynamicsTraced = false; }
  // Dynamic geometry lives for one frame: after the picture is shown it is gone. True if there was some.
  bool endFrame();

  // While a frame is on its way it reads everything that is here: what is drawn meanwhile goes elsewhere, and nothing
  // else may be changed.
  void lend() { mLent = true; }
  void giveBack() { mLent = false; }

 private:
  void startNextFrame();

  GeometrySet mStatics;
  std::array<GeometrySet, 2> mDynamics;  // one is drawn into while the other one is traced
  size_t mMaking = 0;                    // the former
  Accel mStaticAccel, mDynamicAccel;
  double mStaticBuildMilliseconds = 0;
  bool mInStaticScene = false;
  bool mDynamicsTraced = false;  // they belong to a picture that is done, or on its way
  bool mLent = false;
};

}  // namespace rc::ddk
